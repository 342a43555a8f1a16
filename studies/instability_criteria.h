// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/snap_through.h"
#include <string>
#include <vector>

namespace ballonet::studies
{

/// What becomes of an actuator whose pressure is raised to the end of the judged window. Where several apply, the
/// first.
enum class PathClass {
  not_converged,       ///< the path stopped for a numerical reason: nothing is known
  interaction_failure, ///< the balloon leaves its cage, or the cage does not hold
  losing_control,      ///< the head does not follow the pressure
  overload,            ///< the balloon does not inflate
  weak,                ///< stable, but short of the asked angle
  normal               ///< none of these
};

/// A number of a path and the threshold it is compared with.
struct Criterion {
  std::string name;                       ///< of the threshold's key under [judge]
  PathClass leads_to = PathClass::normal; ///< class of a path that does not meet it (overload: see margin_of)
  std::string what;                       ///< the number, in words
  double value = 0, limit = 0;            ///< NaN: the path has no such number
  std::string unit;                       ///< of both; empty for plain numbers
  bool at_most = true;                    ///< whether the limit is the largest value allowed, or the smallest
  double margin = 0;                      ///< distance to the limit in units of it, negative beyond; NaN: not judged
};

/// What is to be known of an actuator beside its path.
struct JudgedActuator {
  double cage_radius = 0;    ///< R_i: inner radius of the ribs, mm
  double rib_thickness = 0;  ///< t_r, mm
  double rib_width = 0;      ///< b, mm
  double balloon_radius = 0; ///< outer, at rest, mm
  double limit_pressure = 0; ///< of the free balloon, MPa
};

/// Limit pressure of a long neo-Hookean tube with closed ends, 1.5 C10 t / R_mid = 0.75 mu t / R_mid (thin wall,
/// exact coefficient 0.7497 at hoop stretch 1.577). `radius`: outer, at rest. MPa.
double tube_limit_pressure(double shear_modulus, double wall, double radius);

/// Every criterion of the judged part of a path, which has at least one state. A margin is (limit - value) / limit or
/// its negative, with a limit of zero taken as one.
std::vector<Criterion> criteria_of(const std::vector<PathState> &path, const std::vector<SnapThrough> &snaps,
                                   const Judge &judge, const JudgedActuator &actuator);

/// How far the path is from a class other than normal and not_converged, by the criteria of that class; negative: it is
/// in it. The smallest margin; for overload the larger one of the angle's and the cause's, since it takes both, where
/// the cause is the smaller one of the limit pressure's and the radius's. NaN if nothing could be judged.
double margin_of(PathClass path_class, const std::vector<Criterion> &criteria);

/// "bulge of the balloon 4.2 mm, at most 3.5 mm"
std::string words_of(const Criterion &criterion);

/// A number in three digits, with its unit if it has one.
std::string rounded_text(double number, const std::string &unit = {});

} // namespace ballonet::studies
