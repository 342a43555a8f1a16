// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/rib_chain.h"

namespace ballonet::solver::reduced
{

/// The stages of a balloon in its cage, in the order in which a path goes through them.
enum class Stage {
  separation,   ///< the balloon does not press on the head
  insufficient, ///< it does, but does not touch the ribs
  sufficient,   ///< it lies on the ribs
  excessive     ///< it bulges out beyond them
};

/// One row of a path.
struct State {
  double time = 0;              ///< s; 0 on a static path
  double pressure = 0;          ///< MPa
  double angle = 0;             ///< rad, of the head, positive towards the back wall
  double outer_radius = 0;      ///< mm, of the balloon (b)
  double axial_stretch = 0;     ///< 1, of the balloon (z)
  double thrust = 0;            ///< N, of the balloon on the head (F)
  double contact_pressure = 0;  ///< MPa, of the balloon on the ribs (q); on a ramp without contact, the unbalanced one
  double balloon_stiffness = 0; ///< N mm/rad per gap (k_b)
  bool touches_ribs = false;    ///< the balloon lies on the ribs
  double bulge_ratio = 0;       ///< 1, of the widest gap: 1 or more, the balloon runs out of it
  double bulge = 0;             ///< mm, largest excess of the balloon's radius over the ribs' inner radius
  Stage stage = Stage::separation;
  Angles al; ///< rad, absolute angles of the units

  std::vector<double> gap_angle() const { return gap_angles(al); } ///< rad, from the bottom
};

} // namespace ballonet::solver::reduced
