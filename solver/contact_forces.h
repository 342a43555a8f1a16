// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairing.h"
#include "solver/virtual_work.h"
#include <memory>

namespace ballonet::solver::contact
{

/// Nodal forces of patches, added to the system once for each patch that is touched.
class ForceBuffer
{
public:
  explicit ForceBuffer(const ContactPairing &pairing) : patches_(pairing.patches()), forces_(patches_.size()) {}

  void add(std::uint32_t patch, const NodeWeights &weights, const Point3 &force)
  {
    auto &forces = forces_[patch];
    if (!forces)
      forces = std::make_unique<std::array<double, 81>>();
    for (std::size_t b = 0; b < patches_[patch].nodes.size(); ++b)
      for (int i = 0; i < 3; ++i)
        (*forces)[3 * b + i] += weights[b] * force[i];
  }

  void flush(Assembly &assembly) const
  {
    for (std::size_t p = 0; p < patches_.size(); ++p)
      if (forces_[p])
        assembly.add_residual(patches_[p].nodes, std::span(*forces_[p]).first(3 * patches_[p].nodes.size()));
  }

private:
  const std::vector<Patch> &patches_;
  std::vector<std::unique_ptr<std::array<double, 81>>> forces_;
};

} // namespace ballonet::solver::contact
