// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_patch.h"
#include "solver/mesh.h"
#include "solver/types.h"
#include <functional>
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

/// The Gauss points of a face, n x n.
struct FaceQuadrature {
  explicit FaceQuadrature(int points_per_side);
  std::vector<PatchShapes> shapes;
  std::vector<double> weight;
  std::uint32_t size() const { return static_cast<std::uint32_t>(weight.size()); }
};

/// A face that feels the contact at its quadrature points.
struct SecondaryFace {
  Face face;
  std::array<Node, 9> nodes;
  std::vector<double> area; ///< reference area of each point, mm^2
};

/// A patch that shares a side of its face with another one.
struct Neighbour {
  std::uint32_t patch;
  int side;      ///< of the neighbour: low 0, high 0, low 1, high 1
  bool reversed; ///< the parameters along the common side run against each other
};

/// The surface inside a cell at a depth behind one of its faces: the material points at a fixed fraction of the cell's
/// thickness, so it follows the body exactly. It reaches up to the cell's sides, except where the neighbouring face of
/// the same cell is primary too: there it ends at the same depth behind that one, which rounds the edge between them.
struct PrimaryPatch {
  Face face;
  std::uint32_t surface;              ///< index into the names of the primary surfaces
  std::array<Node, 27> cell_nodes;    ///< lexicographic
  std::array<double, 3> layer_weight; ///< of the three layers behind the face
  double depth_fraction;              ///< of the cell's reference thickness behind the face, at most 1/2
  PatchRange range;
  double radius; ///< contact begins at this distance, mm: the depth in the reference configuration
  /// The patches beyond the sides low 0, high 0, low 1, high 1 of the face, whether the surface goes on or turns there.
  std::array<std::optional<Neighbour>, 4> neighbour;
};

std::vector<SecondaryFace> secondary_faces(const Mesh &, const std::vector<std::string> &names, const FaceQuadrature &,
                                           const std::function<bool(std::uint32_t cell)> &owned);

/// `thickness`: the depth in mm. Cells thinner than twice that get half their own thickness, so contact never begins
/// outside the real surface.
std::vector<PrimaryPatch> primary_patches(const Mesh &, const std::vector<std::string> &names, double thickness);

/// The field at the nodes of a face.
template <class Field>
PatchNodes at_nodes(std::span<const Node, 9> nodes, const Field &field)
{
  PatchNodes values;
  for (int a = 0; a < 9; ++a)
    values[a] = field(nodes[a]);
  return values;
}

/// The field at the nine nodes of the patch: combinations of the three layers of cell nodes.
template <class Field>
PatchNodes at_depth(const PrimaryPatch &patch, const Field &field)
{
  const auto &column = columns_behind(patch.face.local);
  PatchNodes values;
  for (int c = 0; c < 9; ++c)
    for (int k = 0; k < 3; ++k)
      values[c] += patch.layer_weight[k] * field(patch.cell_nodes[column[3 * c + k]]);
  return values;
}

/// The parameters in `neighbour` of a point xi on the common side, `side` of the patch.
Parameters2 across(const Parameters2 &xi, int side, const Neighbour &, const PrimaryPatch &neighbour);

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
