// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_work.h"
#include "tests/support/box_mesh.h"
#include "tests/support/dense_assembly.h"
#include "tests/support/nodal_fields.h"

/// Small configurations of two bodies in contact: "block", 2 x 2 x 1 mm, primary, and "plate", secondary.
namespace ballonet::tests
{

using namespace solver;
using Vector = solver::contact::Point3;

inline bool all_owned(std::uint32_t) { return true; }

/// Adds a body: the image of the unit cube under `map`, with sides "<name>.x0" ... "<name>.z1".
inline void add_block(Mesh &mesh, const std::string &name, std::array<int, 3> cells,
                      const std::function<std::array<double, 3>(std::array<double, 3>)> &map)
{
  mesh = beside(std::move(mesh), box_mesh(cells[0], cells[1], cells[2], map, name, name + "."));
}

/// Moves every node by up to `by` in each direction: distorted quadratic cells.
inline void distort(Mesh &mesh, double by, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> shift(-by, by);
  for (auto &node : mesh.nodes)
    for (double &x : node)
      x += shift(generator);
}

inline std::vector<std::string> all_sides(const std::string &name)
{
  return {name + ".x0", name + ".x1", name + ".y0", name + ".y1", name + ".z0", name + ".z1"};
}

struct ContactScene {
  Mesh mesh;
  ContactPair pair;
  State state;
};

/// A plate, 0.4 mm thick, whose lower side lies at `centre` with the outward direction `up` of the block's
/// surface, pressed into the distorted block.
inline ContactScene contact_scene(const Vector &centre, Vector up, double width = 1.2, double distortion = 0.03,
                                  std::array<int, 3> block_cells = {1, 1, 1})
{
  ContactScene scene;
  add_block(scene.mesh, "block", block_cells, [](auto p) { return std::array<double, 3>{2 * p[0], 2 * p[1], p[2]}; });
  up /= up.norm();
  Vector side = cross_product_3d(up, Vector({0.36, 0.48, -0.8}));
  side /= side.norm();
  const Vector other = cross_product_3d(up, side);
  add_block(scene.mesh, "plate", {1, 1, 1}, [&](auto p) {
    const Vector x = centre + width * (p[0] - 0.5) * side + width * (p[1] - 0.5) * other + 0.4 * p[2] * up;
    return std::array<double, 3>{x[0], x[1], x[2]};
  });
  distort(scene.mesh, distortion, 11);
  scene.pair = {"pair", {"plate.z0"}, all_sides("block"), 0.3, 0.3, 9, 0.06};
  scene.state.displacement.assign(3 * scene.mesh.nodes.size(), 0.);
  return scene;
}

inline ContactScene interior_scene() { return contact_scene(Vector({1, 1, 0.9}), Vector({0, 0, 1})); }
inline ContactScene edge_scene() { return contact_scene(Vector({1.85, 1, 0.85}), Vector({1, 0, 1})); }
inline ContactScene corner_scene() { return contact_scene(Vector({1.82, 1.82, 0.82}), Vector({1, 1, 1}), 0.4); }

/// Moves the plate's nodes (all after the block's).
inline State with_plate_moved(const ContactScene &scene, const Vector &by)
{
  State state = scene.state;
  const Node first_plate_node = *std::min_element(scene.mesh.cells.back().begin(), scene.mesh.cells.back().end());
  for (std::size_t i = 3 * first_plate_node; i < state.displacement.size(); ++i)
    state.displacement[i] += by[i % 3];
  return state;
}

} // namespace ballonet::tests
