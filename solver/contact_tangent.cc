// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_tangent.h"
#include "solver/contact_block.h"
#include <algorithm>
#include <memory>
#include <tuple>

namespace ballonet::solver::contact
{

namespace
{

/// Second variation of area * law(radius - distance), see ContactBlock. With r = x - y, d = |r|, n = r / d
/// delta d = n . delta r and delta^2 d = (|delta r|^2 - (n . delta r)^2 - b . A^-1 b) / d, where
/// b_k = delta r . y_,k + d n . delta y_,k and A is the hessian of d^2 / 2 over the free parameters.
ContactBlock::NormalForm normal_form(const ClosestPoint &c, double stiffness, double force)
{
  ContactBlock::NormalForm form{};
  const double stress = force / std::max(c.distance, 1e-12);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      form[i][j] = stiffness * c.normal[i] * c.normal[j] - stress * ((i == j) - c.normal[i] * c.normal[j]);

  std::array<std::array<double, 5>, 2> b{};
  for (int k = 0; k < 2; ++k)
    if (c.free[k]) {
      for (int i = 0; i < 3; ++i)
        b[k][i] = c.tangent[k][i];
      b[k][3 + k] = c.distance;
    }
  const double a00 = c.free[0] ? c.hessian[0] : 1, a11 = c.free[1] ? c.hessian[2] : 1;
  const double a01 = c.free[0] && c.free[1] ? c.hessian[1] : 0;
  const double determinant = a00 * a11 - a01 * a01;
  if (determinant <= 1e-12 * std::abs(a00 * a11) || a00 <= 0)
    return form; // at a centre of curvature of the patch: the closest point is not unique
  const double scale = stress / determinant;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      form[i][j] +=
          scale * (a11 * b[0][i] * b[0][j] - a01 * (b[0][i] * b[1][j] + b[1][i] * b[0][j]) + a00 * b[1][i] * b[1][j]);
  return form;
}

/// One point's part of the tangent, in the order in which blocks are filled: exactly one of the pointers is set.
struct Part {
  std::uint32_t secondary, cell, primary; ///< patch, cell of the primary patch, patch
  const NormalContact *normal;
  const SlidingContact *sliding;

  bool same_block(const Part &other) const { return secondary == other.secondary && cell == other.cell; }

  void add_to(ContactBlock &block) const
  {
    if (normal) {
      const PairedPoint &p = normal->point;
      block.add_normal(p.own == secondary, patch_shapes(p.own_xi).value, patch_shapes(p.closest.xi), p.closest.normal,
                       normal_form(p.closest, normal->stiffness, normal->force));
    } else
      block.add_sliding(sliding->point->secondary.weights, sliding->point->primary.weights, sliding->stiffness);
  }
};

std::vector<Part> sorted_parts(const ContactPairing &pairing, const std::vector<NormalContact> &normal,
                               const std::vector<SlidingContact> &sliding)
{
  std::vector<Part> parts;
  auto cell_of = [&](std::uint32_t patch) { return pairing.patches()[patch].face.cell; };
  for (const NormalContact &n : normal) {
    const auto [secondary, primary] = std::minmax(n.point.own, n.point.patch); // secondary patches come first
    parts.push_back({secondary, cell_of(primary), primary, &n, nullptr});
  }
  for (const SlidingContact &s : sliding) {
    const std::uint32_t primary = s.point->primary.patch;
    parts.push_back({s.point->secondary.patch, cell_of(primary), primary, nullptr, &s});
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part &a, const Part &b) {
    return std::tie(a.secondary, a.cell, a.primary) < std::tie(b.secondary, b.cell, b.primary);
  });
  return parts;
}

std::array<Node, 36> block_nodes(const Patch &secondary, const Patch &primary)
{
  std::array<Node, 36> nodes;
  const auto end_of_face = std::copy(secondary.nodes.begin(), secondary.nodes.end(), nodes.begin());
  std::copy(primary.nodes.begin(), primary.nodes.end(), end_of_face);
  return nodes;
}

} // namespace

void add_contact_tangent(const ContactPairing &pairing, const std::vector<NormalContact> &normal,
                         const std::vector<SlidingContact> &sliding, Assembly &assembly)
{
  const auto parts = sorted_parts(pairing, normal, sliding);
  const auto block = std::make_unique<ContactBlock>();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Part &part = parts[k];
    const Patch &primary = pairing.patches()[part.primary];
    part.add_to(*block);
    const bool block_ends = k + 1 == parts.size() || !part.same_block(parts[k + 1]);
    if (block_ends || parts[k + 1].primary != part.primary)
      block->spread(primary);
    if (block_ends) {
      assembly.add_tangent(block_nodes(pairing.patches()[part.secondary], primary), block->values());
      block->clear();
    }
  }
}

} // namespace ballonet::solver::contact
