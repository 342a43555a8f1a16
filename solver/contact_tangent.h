// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_friction.h"
#include "solver/virtual_work.h"

namespace ballonet::solver::contact
{

/// A point under normal contact, with what its tangent needs.
struct NormalContact {
  PairedPoint point;
  double stiffness; ///< area times slope of the law, N/mm
  double force;     ///< area times the pressure of the geometric part, N
};

/// A point under friction with its derivative of the force by x - z.
struct SlidingContact {
  const SlidingPoint *point;
  dealii::Tensor<2, 3> stiffness;
};

/// Adds the tangent of all these points: one block for each secondary face and primary cell that touch.
void add_contact_tangent(const ContactPairing &, const std::vector<NormalContact> &,
                         const std::vector<SlidingContact> &, Assembly &);

} // namespace ballonet::solver::contact
