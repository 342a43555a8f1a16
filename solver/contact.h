// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/parameters.h"
#include "solver/virtual_work.h"
#include <optional>

namespace ballonet::solver
{

namespace contact
{
struct MeanGaps;
}

/// What a contact pair transmits. Ranks' parts are summed with +=.
struct ContactSummary {
  std::vector<Vector3> primary_force; ///< N, on each primary surface in the order of the pair's names
  Vector3 secondary_force = {};       ///< N, on the secondary surface
  double normal_force = 0;            ///< N, sum of the normal forces whatever their directions
  double area = 0;                    ///< mm^2 of reference area in contact; of two passes the mean
  double penetration = 0;             ///< mm, the largest
  std::size_t points = 0;             ///< quadrature points in contact

  ContactSummary &operator+=(const ContactSummary &);
};

/// One quadrature point in contact.
struct ContactPoint {
  Face secondary;
  std::optional<Face> primary; ///< none on a rigid body
  Vector3 position;            ///< mm, present, on the secondary surface
  double area;                 ///< mm^2 of reference area the point stands for, half of it with two passes
  double pressure;             ///< MPa per reference area
  double penetration;          ///< mm; with augmented contact also negative
};

/// The contact of one pair, whatever its primary side is.
class Contact : public VirtualWork
{
public:
  /// Numbers the contact points of all ranks from here on in State::friction; returns where the next pair begins.
  virtual std::size_t number_points_from(std::size_t first) = 0;
  /// The same for the shifts of augmented contact in State::contact_shift.
  virtual std::size_t number_shifts_from(std::size_t first) = 0;
  /// Takes the shifts of a state for all that follows; begin_step does so too.
  virtual void take_shifts(const State &) = 0;
  /// Adds the gaps around the nodes of the shifts, this rank's part.
  virtual void add_gaps(const State &, contact::MeanGaps &) const = 0;
  /// Writes the tractions of friction at the end of a step, this rank's part, MPa.
  virtual void end_step(State &end) const = 0;

  /// Forces and extent of the contact in a state, this rank's part. Friction is the one of the present step: ask before
  /// the next begin_step.
  virtual ContactSummary summary(const State &) const = 0;
  /// All points in contact, this rank's part.
  virtual std::vector<ContactPoint> contact_points(const State &) const = 0;
  /// Normal force on points that touch nothing they are paired with, but would after a search in this state, N, this
  /// rank's part: contact that began after the pairing had been frozen.
  virtual double missed_force(const State &) const { return 0; }
};

} // namespace ballonet::solver
