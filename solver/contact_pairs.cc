// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_pairs.h"
#include "solver/contact_rigid.h"
#include "solver/contact_work.h"
#include "solver/free_surface.h"
#include "solver/penetration_check.h"
#include "solver/rigid_penetration.h"
#include "solver/self_penetration.h"
#include <algorithm>

namespace ballonet::solver
{

ContactPairs::ContactPairs(const Parameters &parameters, const Discretization &discretization)
    : parameters_(parameters), discretization_(discretization), augmentation_(discretization.comm())
{
  for (const auto &pair : parameters.contact_pairs) {
    build(pair);
    n_points_ = contacts_.back()->number_points_from(n_points_);
    augmentation_.add(*contacts_.back(), pair);
  }
}

ContactPairs::~ContactPairs() = default;

std::vector<VirtualWork *> ContactPairs::works() const
{
  std::vector<VirtualWork *> works;
  for (const auto &contact : contacts_)
    works.push_back(contact.get());
  return works;
}

void ContactPairs::build(const ContactPair &pair)
{
  const Mesh &mesh = discretization_.mesh();
  const auto owned = [this](std::uint32_t cell) { return discretization_.owns(cell); };
  for (const RigidBody &body : parameters_.rigid_bodies)
    if (std::ranges::count(pair.primary, body.name) > 0) {
      contacts_.push_back(std::make_unique<RigidContactWork>(mesh, pair, body, owned));
      add_check<RigidPenetration>(mesh, pair, body, pair.penetration_limit);
      return;
    }
  contacts_.push_back(std::make_unique<ContactWork>(mesh, pair, owned));
  build_checks(pair);
}

template <class Check, class... Arguments>
void ContactPairs::add_check(const Arguments &...arguments)
{
  checks_.push_back([check = std::make_shared<const Check>(arguments...)](const State &s) { return check->find(s); });
}

/// For deformable bodies: those on one side of the pair, and those on both.
void ContactPairs::build_checks(const ContactPair &pair)
{
  const Mesh &mesh = discretization_.mesh();
  const Flags secondary = bodies_of(mesh, pair.secondary), primary = bodies_of(mesh, pair.primary);
  if (secondary != primary)
    add_check<PenetrationCheck>(mesh, pair, pair.penetration_limit);
  if (std::ranges::count(both(secondary, primary), true) > 0)
    add_check<SelfPenetration>(mesh, pair, pair.penetration_limit);
}

void ContactPairs::end_step(State &end) const
{
  end.friction.assign(3 * n_points_, 0.);
  for (const auto &contact : contacts_)
    contact->end_step(end);
  MPI_Allreduce(MPI_IN_PLACE, end.friction.data(), end.friction.size(), MPI_DOUBLE, MPI_SUM, discretization_.comm());
}

std::vector<ContactSummary> ContactPairs::summaries(const State &state) const
{
  std::vector<ContactSummary> summaries;
  for (const auto &contact : contacts_) {
    auto s = contact->summary(state);
    std::vector<double> sums = {s.area, static_cast<double>(s.points), s.normal_force};
    sums.insert(sums.end(), s.secondary_force.begin(), s.secondary_force.end());
    for (const auto &force : s.primary_force)
      sums.insert(sums.end(), force.begin(), force.end());
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), sums.size(), MPI_DOUBLE, MPI_SUM, discretization_.comm());
    MPI_Allreduce(MPI_IN_PLACE, &s.penetration, 1, MPI_DOUBLE, MPI_MAX, discretization_.comm());
    s.area = sums[0];
    s.points = sums[1];
    s.normal_force = sums[2];
    std::copy_n(&sums[3], 3, s.secondary_force.begin());
    for (std::size_t i = 0; i < s.primary_force.size(); ++i)
      std::copy_n(&sums[6 + 3 * i], 3, s.primary_force[i].begin());
    summaries.push_back(s);
  }
  return summaries;
}

std::vector<std::vector<ContactPoint>> ContactPairs::points(const State &state) const
{
  std::vector<std::vector<ContactPoint>> points;
  for (const auto &contact : contacts_)
    points.push_back(contact->contact_points(state));
  return points;
}

/// Contact that a new search finds in a converged state, and that its equations do not know.
std::string ContactPairs::missed(const State &state, const std::vector<ContactSummary> &found) const
{
  constexpr double share = 0.02; // of the normal force that is allowed to be missed
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    double force = contacts_[i]->missed_force(state);
    MPI_Allreduce(MPI_IN_PLACE, &force, 1, MPI_DOUBLE, MPI_SUM, discretization_.comm());
    if (force > share * std::max(found[i].normal_force, parameters_.newton.force_floor))
      return "contact pair \"" + parameters_.contact_pairs[i].name + "\": a new search finds " + std::to_string(force) +
             " N more normal force than the present pairs carry";
  }
  return {};
}

std::string ContactPairs::objection(const State &state) const
{
  const auto found = summaries(state);
  if (const auto reason = missed(state, found); !reason.empty())
    return reason;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (const auto &pair = parameters_.contact_pairs[i]; found[i].penetration > pair.penetration_limit)
      return "contact pair \"" + pair.name + "\" penetrates by " + std::to_string(found[i].penetration) +
             " mm, allowed are " + std::to_string(pair.penetration_limit);
  return intrusion(state);
}

/// The node that is deepest where it must not be.
std::string ContactPairs::intrusion(const State &state) const
{
  for (const auto &check : checks_)
    if (const auto violations = check(state); !violations.empty()) {
      const auto &worst = *std::max_element(violations.begin(), violations.end(),
                                            [](const auto &a, const auto &b) { return a.depth < b.depth; });
      return std::to_string(violations.size()) + " nodes lie inside or beyond body \"" + worst.body +
             "\", the deepest by " + std::to_string(worst.depth) + " mm at (" + std::to_string(worst.position[0]) +
             ", " + std::to_string(worst.position[1]) + ", " + std::to_string(worst.position[2]) + ") mm";
    }
  return {};
}

} // namespace ballonet::solver
