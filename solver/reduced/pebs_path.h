// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/pebs_model.h"
#include <string>

namespace ballonet::solver::reduced
{

/// How a path ended. Everything but complete is a failure: a value with a reason.
enum class Ending {
  complete,       ///< it reached the stop, or its duration
  no_droop,       ///< no stable equilibrium under the weight alone was found
  no_equilibrium, ///< the static path broke off
  diverged        ///< the time step was too long for the motion
};

enum class EventKind {
  head_contact, ///< the balloon begins to press on the head
  upright,      ///< the head passes 0 deg
  limit,        ///< a pressure maximum: under rising pressure the actuator snaps
  rib_contact,  ///< the balloon reaches the ribs
  bulged,       ///< its bulge passes the ribs' outer radius
  ran_out       ///< it runs out of the widest gap
};

/// The word of an event, "rib_contact".
std::string word_of(EventKind kind);

struct Event {
  EventKind kind;
  double pressure; ///< MPa
  double angle;    ///< rad
};

struct Path {
  Ending ending = Ending::complete;
  std::string reason; ///< why, unless complete
  std::vector<State> rows;
  std::vector<Event> events; ///< in their order; the first of each kind, and of limits all

  /// The first event of a kind, if there is one.
  std::optional<Event> first(EventKind kind) const;

  /// Head angle (rad) someone sees who raises the pressure slowly: at the first state whose running pressure maximum
  /// reaches `pressure`, interpolated between rows; at the stop if a complete path ends below it. Nothing otherwise.
  std::optional<double> angle_at(double pressure) const;
};

/// Numbers that need no path.
struct Answers {
  double hinge_stiffness = 0;             ///< k, N mm/rad
  double lever = 0;                       ///< e, mm
  double self_weight_number = 0;          ///< Lambda of the backbone: above 7.3 it does not carry itself
  double overload_index = 0;              ///< 1.5 C10 t / (R window): above 1 the balloon does not inflate
  BalloonTube::FreeState free_limit = {}; ///< limit of the balloon alone
  std::optional<double> backbone_droop;   ///< rad, without the balloon; nothing if none is found
  std::optional<double> droop;            ///< rad, with its weight
};

/// `window`: the largest pressure of the working range, MPa.
Answers answers(const PebsModel &model, double window = 0.064);

/// (sum th)^2 / (N sum th^2) of the gap angles: 1 if all gaps open alike.
double participation_number(const Angles &al);

/// The quasi-static path, controlled by the head angle, from zero pressure to the stop. Limits and first contact are
/// refined between the rows; other events are interpolated.
Path static_path(const PebsModel &model);

} // namespace ballonet::solver::reduced
