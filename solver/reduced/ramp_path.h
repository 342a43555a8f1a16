// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/pebs_path.h"

namespace ballonet::solver::reduced
{

/// The dynamic path: the pressure grows at a constant rate from the droop at rest, with inertia.
///     M(al) al'' + velocity forces + (mass_damping M + hinge_damping K_h) al' + residual = F e at the top unit
///     b' = radial_mobility (P - p(z, b)),  b <= Ri,   F = max(0, q pi b^2 - Fred) with q = P - p on the ribs, else 0
/// where K_h is the elastic stiffness of the hinges alone. The head is pushed, not pulled; z = (H + e al_N) / L without
/// u_wall. Semi-implicit Euler: forces from the start of the step, damping implicit, then angles with the new velocity;
/// the radius before that, in four linearly implicit substeps at held P and z, from 1.001 B. A row is written after the
/// first step, every steps_per_row, and the last; its angle and radius are those of the end of the step, its pressure,
/// stretch, thrust and contact pressure those at its start (with the new radius). Every one of these choices was found
/// from the reference trajectory, which it reproduces to a few hundredths of a degree. The two damping constants were
/// fitted to it: they are those of that actuator (about 8 % of critical at its first mode) and not derived from its
/// parameters.
Path ramp_path(const PebsModel &model);

} // namespace ballonet::solver::reduced
