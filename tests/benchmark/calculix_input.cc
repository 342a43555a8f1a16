// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/benchmark/calculix_input.h"
#include "solver/discretization.h"
#include "tests/benchmark/benchmark_case.h"
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>

namespace ballonet::tests
{

using namespace solver;

namespace
{

/// Position in the 27-node hexahedron of CalculiX's 20 nodes: corners below and above, edges below, above, upright.
constexpr int node_of_27[20] = {0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11, 17, 15};
/// CalculiX's number of the faces x-, x+, y-, y+, z-, z+.
constexpr int face_number[6] = {6, 4, 3, 5, 1, 2};

void write_mesh(std::ostream &out, const Mesh &mesh, const std::string &element)
{
  out << "*NODE, NSET=ALL\n";
  for (const auto node : shared_nodes(mesh))
    out << node + 1 << ", " << mesh.nodes[node][0] << ", " << mesh.nodes[node][1] << ", " << mesh.nodes[node][2]
        << '\n';
  out << "*ELEMENT, TYPE=" << element << ", ELSET=BODY\n";
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    out << c + 1;
    for (int a = 0; a < 20; ++a)
      out << (a == 10 ? ",\n" : ", ") << mesh.cells[c][node_of_27[a]] + 1;
    out << '\n';
  }
}

void write_material(std::ostream &out, const Material &m, double bulk_ratio)
{
  out << "*MATERIAL, NAME=M\n";
  if (m.law == Law::saint_venant)
    out << "*ELASTIC\n" << *m.youngs_modulus << ", " << *m.poisson_ratio << '\n';
  else
    out << "*HYPERELASTIC, NEO HOOKE\n"
        << *m.c10 << ", " << (bulk_ratio > 0 ? 1 / (bulk_ratio * *m.c10) : *m.d1) << '\n';
  out << "*SOLID SECTION, ELSET=BODY, MATERIAL=M\n";
}

void write_supports(std::ostream &out, const Mesh &mesh, const std::vector<Support> &supports)
{
  const auto shared = shared_nodes(mesh);
  out << "*BOUNDARY\n";
  for (const auto &support : supports)
    for (const auto node : surface_nodes(mesh, support.surface))
      for (const auto &direction : support.fix)
        if (std::binary_search(shared.begin(), shared.end(), node))
          out << node + 1 << ", " << direction[0] - 'x' + 1 << '\n';
}

/// A parallelogram's area from three of its corners.
double area(const Mesh &mesh, const std::array<Node, 9> &face)
{
  const auto edge = [&](int corner, int d) { return mesh.nodes[face[corner]][d] - mesh.nodes[face[0]][d]; };
  Vector3 normal;
  for (int d = 0; d < 3; ++d) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    normal[d] = edge(2, e) * edge(6, f) - edge(2, f) * edge(6, e);
  }
  return std::hypot(normal[0], normal[1], normal[2]);
}

/// Nodal forces of a uniform dead traction on 8-node faces: -1/12 of the force on a corner, 1/3 on an edge.
void write_traction(std::ostream &out, const Mesh &mesh, const Load &load)
{
  std::map<Node, double> weight;
  for (const auto &face : faces_of(mesh, load.surface)) {
    const auto nodes = face_nodes(mesh, face);
    for (int a = 0; a < 9; ++a)
      if (a != 4)
        weight[nodes[a]] += area(mesh, nodes) * (a % 2 ? 1. / 3 : -1. / 12);
  }
  out << "*CLOAD\n";
  for (const auto &[node, w] : weight)
    for (int d = 0; d < 3; ++d)
      if (load.traction[d] != 0)
        out << node + 1 << ", " << d + 1 << ", " << w * load.traction[d] << '\n';
}

void write_load(std::ostream &out, const Mesh &mesh, const Load &load)
{
  if (load.traction != Vector3{0, 0, 0})
    write_traction(out, mesh, load);
  if (load.pressure != 0) {
    out << "*DLOAD\n";
    for (const auto &face : faces_of(mesh, load.surface))
      out << face.cell + 1 << ", P" << face_number[face.local] << ", " << load.pressure << '\n';
  }
}

} // namespace

void write_calculix_input(std::ostream &out, const Mesh &mesh, const Parameters &parameters, const std::string &element,
                          double bulk_ratio)
{
  out << std::setprecision(12);
  write_mesh(out, mesh, element);
  write_material(out, parameters.materials.at(0), bulk_ratio);
  write_supports(out, mesh, parameters.supports);
  out << "*STEP, NLGEOM, INC=1000\n*STATIC, SOLVER=SPOOLES\n" << 1. / parameters.path.load_steps << ", 1\n";
  for (const auto &load : parameters.loads)
    write_load(out, mesh, load);
  out << "*NODE PRINT, NSET=ALL, FREQUENCY=1000\nU\n*END STEP\n"; // the last increment is always printed
}

} // namespace ballonet::tests
