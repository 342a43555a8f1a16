// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/parameters.h"

namespace ballonet::solver::reduced
{

/// One corrugation of the back wall as an elastic hinge for small angles.
struct Hinge {
  double strip_stiffness = 0;     ///< N mm/rad, of the unfolded strip: E I w / S
  double curvature_stiffness = 0; ///< N mm/rad, because the wall follows the cylinder; an upper bound
  double axial_stiffness = 0;     ///< N/mm, along the axis through the elastic centre (k_u)
  double lever = 0;               ///< mm, from the balloon's axis to the axis of rotation (e)
  double fold_length = 0;         ///< mm, of the middle line (S)

  double stiffness() const { return strip_stiffness + curvature_stiffness; } ///< k
};

/// Plane arch over the gap with the middle line (-g/2 cos phi, rise sin phi), phi from 0 to pi: half an ellipse, a
/// semicircle if the rise is half the gap. (Other curves with the same rise are up to 6 % off the reference's
/// stiffness.) With S = int ds, Y1 = int y ds, Y2 = int y^2 ds, Sx = int cos^2(slope) ds and the plate's E I1 = E t^3 /
/// (12 (1 - nu^2)):
///     rotation about y_e = Y1 / S;  k_strip = E I1 w / S;  1 / k_u1 = (Y2 - Y1^2 / S) / E I1 + Sx / (E t)
///     k_curv = k_u1 Rw^3 [beta + sin(2 beta) / 2 - 2 sin^2(beta) / beta],  beta = w / (2 Rw),  Rw = Ri + t / 2
Hinge make_hinge(const Parameters &parameters);

} // namespace ballonet::solver::reduced
