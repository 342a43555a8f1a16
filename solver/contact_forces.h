// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairing.h"
#include "solver/virtual_work.h"
#include <memory>

namespace ballonet::solver::contact
{

/// Nodal forces of faces and cells, added to the system once for each face and patch that is touched.
class ForceBuffer
{
public:
  explicit ForceBuffer(const ContactPairing &pairing)
      : pairing_(pairing), faces_(pairing.faces().size()), patches_(pairing.patches().size())
  {
  }

  void add_face(std::uint32_t face, const std::array<double, 9> &shapes, const Point3 &force)
  {
    for (int a = 0; a < 9; ++a)
      add(faces_[face], a, shapes[a], force);
  }

  void add_patch(std::uint32_t patch, const std::array<double, 9> &shapes, const Point3 &force)
  {
    const PrimaryPatch &p = pairing_.patches()[patch];
    const auto &column = columns_behind(p.face.local);
    for (int c = 0; c < 9; ++c)
      for (int k = 0; k < 3; ++k)
        add(patches_[patch], column[3 * c + k], shapes[c] * p.layer_weight[k], force);
  }

  void add_cell(std::uint32_t patch, const std::array<double, 27> &weights, const Point3 &force)
  {
    for (int b = 0; b < 27; ++b)
      add(patches_[patch], b, weights[b], force);
  }

  void flush(Assembly &assembly) const
  {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (faces_[f])
        assembly.add_residual(pairing_.faces()[f].nodes, *faces_[f]);
    for (std::size_t p = 0; p < patches_.size(); ++p)
      if (patches_[p])
        assembly.add_residual(pairing_.patches()[p].cell_nodes, *patches_[p]);
  }

private:
  const ContactPairing &pairing_;
  std::vector<std::unique_ptr<std::array<double, 27>>> faces_;
  std::vector<std::unique_ptr<std::array<double, 81>>> patches_;

  template <class Forces>
  static void add(std::unique_ptr<Forces> &forces, int node, double weight, const Point3 &force)
  {
    if (!forces)
      forces = std::make_unique<Forces>();
    for (int i = 0; i < 3; ++i)
      (*forces)[3 * node + i] += weight * force[i];
  }
};

} // namespace ballonet::solver::contact
