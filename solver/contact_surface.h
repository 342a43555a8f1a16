// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_patch.h"
#include "solver/mesh.h"
#include "solver/types.h"
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ballonet::solver::contact
{

/// Nodes of a cell seen from one of its faces: entry 3 c + k is the local number of the node in column c = i + 3 j
/// behind the face, k layers deep (0: on the face, 2: on the opposite face). Columns run along the two remaining
/// reference directions in ascending order.
const std::array<std::uint8_t, 27> &columns_behind(std::uint32_t local_face);

/// +1 where tangent_0 x tangent_1 of the columns points out of the cell (positive Jacobian), otherwise -1.
double outward_sign(std::uint32_t local_face);

/// All faces of the named surfaces without repetition, in their order; throws std::invalid_argument on an unknown name.
struct NamedFace {
  Face face;
  std::uint32_t surface; ///< the first name that holds it
};
std::vector<NamedFace> faces_of(const Mesh &, const std::vector<std::string> &names);

/// Node positions X + u.
struct CurrentPosition {
  const Mesh &mesh;
  std::span<const double> displacement;
  Point3 operator()(Node n) const
  {
    Point3 x;
    for (int i = 0; i < 3; ++i)
      x[i] = mesh.nodes[n][i] + displacement[3 * n + i];
    return x;
  }
};

/// Node positions at rest.
struct ReferencePosition {
  const Mesh &mesh;
  Point3 operator()(Node n) const { return Point3({mesh.nodes[n][0], mesh.nodes[n][1], mesh.nodes[n][2]}); }
};

/// The nine nodes of a face at rest.
PatchNodes face_at_rest(const Mesh &mesh, const Face &face);

/// A nodal vector field, three values per node.
struct NodalField {
  std::span<const double> values;
  Point3 operator()(Node n) const
  {
    Point3 v;
    for (int i = 0; i < 3; ++i)
      v[i] = values[3 * n + i];
    return v;
  }
};

/// A patch that shares a side of its face with another one.
struct Neighbour {
  std::uint32_t patch;
  int side;      ///< of the neighbour: low 0, high 0, low 1, high 1
  bool reversed; ///< the parameters along the common side run against each other
};

/// A point at which a patch feels the contact.
struct QuadraturePoint {
  Parameters2 xi;
  double area; ///< of the real face in the reference configuration that the point stands for, mm^2
};

/// The surface inside a cell at a depth behind one of its faces, or that face itself: the material points at a fixed
/// fraction of the cell's thickness, so it follows the body exactly. It reaches up to the cell's sides, except where a
/// neighbouring face of the same cell belongs to the surface too: there it ends at the same depth behind that one,
/// which rounds the edge between them.
struct Patch {
  Face face;
  std::uint32_t surface;   ///< index into the names it was made from
  std::vector<Node> nodes; ///< the nine of the face at depth zero, otherwise those of the cell; lexicographic
  std::array<double, 3> layer_weight; ///< of the three layers behind the face
  double depth_fraction;              ///< of the cell's reference thickness behind the face, at most 1/2
  PatchRange range;
  double depth; ///< mm in the reference configuration
  /// The patches beyond the sides low 0, high 0, low 1, high 1 of the face, whether the surface goes on or turns there.
  std::array<std::optional<Neighbour>, 4> neighbour = {};
  std::vector<QuadraturePoint> points = {}; ///< none where the patch is only felt by others
  std::size_t first_point = 0;              ///< number of its first point among those of all ranks
  /// Of its corners, see contact_shift.h.
  std::array<std::uint32_t, 4> shift_node = {};

  std::size_t n_layers() const { return nodes.size() / 9; }
  /// Index into `nodes` of the node in a column, some layers deep.
  std::size_t place(std::size_t column, std::size_t layer) const
  {
    return n_layers() == 1 ? column : columns_behind(face.local)[3 * column + layer];
  }
};

/// The patches of the named surfaces. `depth` in mm; cells thinner than twice that get half their own thickness, so
/// contact never begins outside the real surface.
std::vector<Patch> patches_of(const Mesh &, const std::vector<std::string> &names, double depth);

/// A field at nine nodes.
template <class Field>
PatchNodes at_nodes(std::span<const Node, 9> nodes, const Field &field)
{
  PatchNodes values;
  for (int a = 0; a < 9; ++a)
    values[a] = field(nodes[a]);
  return values;
}

/// The field at the nine nodes of the patch: combinations of the layers of nodes behind them.
template <class Field>
PatchNodes at_depth(const Patch &patch, const Field &field)
{
  PatchNodes values;
  for (std::size_t c = 0; c < 9; ++c)
    for (std::size_t k = 0; k < patch.n_layers(); ++k)
      values[c] += patch.layer_weight[k] * field(patch.nodes[patch.place(c, k)]);
  return values;
}

/// Weights of `Patch::nodes`; those beyond its number of nodes are zero.
using NodeWeights = std::array<double, 27>;

/// The weights that give the value with these shape values of the patch.
NodeWeights node_weights(const Patch &, const std::array<double, 9> &shapes);

/// The field with the given weights of the patch's nodes.
template <class Field>
Point3 weighted_sum(const Patch &patch, const NodeWeights &weights, const Field &field)
{
  Point3 value;
  for (std::size_t b = 0; b < patch.nodes.size(); ++b)
    value += weights[b] * field(patch.nodes[b]);
  return value;
}

/// The parameters in `neighbour` of a point xi on the common side, `side` of the patch.
Parameters2 across(const Parameters2 &xi, int side, const Neighbour &, const Patch &neighbour);

/// The part of a patch within its range as a patch of its own; biquadratic again, so nothing is lost.
PatchNodes within_range(const PatchNodes &, const PatchRange &);

/// Columns of a face at the middles of its sides low 0, high 0, low 1, high 1.
constexpr std::array<int, 4> middle_of_side = {3, 5, 1, 7};

/// Sum of nodal values with the given shape values.
inline Point3 interpolate(const PatchNodes &nodes, const std::array<double, 9> &shape)
{
  Point3 sum;
  for (int a = 0; a < 9; ++a)
    sum += shape[a] * nodes[a];
  return sum;
}

} // namespace ballonet::solver::contact
