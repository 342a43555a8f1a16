// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_work.h"
#include "solver/contact_forces.h"
#include "solver/contact_shift.h"
#include "solver/contact_step.h"
#include "solver/contact_tangent.h"
#include <cmath>
#include <numeric>

namespace ballonet::solver
{

using namespace contact;

namespace
{

Vector3 &operator+=(Vector3 &sum, const Point3 &v)
{
  for (int i = 0; i < 3; ++i)
    sum[i] += v[i];
  return sum;
}

Vector3 to_array(const Point3 &v) { return {v[0], v[1], v[2]}; }

} // namespace

ContactSummary &ContactSummary::operator+=(const ContactSummary &other)
{
  primary_force.resize(std::max(primary_force.size(), other.primary_force.size()), Vector3{});
  for (std::size_t s = 0; s < other.primary_force.size(); ++s)
    for (int i = 0; i < 3; ++i)
      primary_force[s][i] += other.primary_force[s][i];
  for (int i = 0; i < 3; ++i)
    secondary_force[i] += other.secondary_force[i];
  normal_force += other.normal_force;
  area += other.area;
  penetration = std::max(penetration, other.penetration);
  points += other.points;
  return *this;
}

ContactWork::ContactWork(const Mesh &mesh, const ContactPair &pair,
                         const std::function<bool(std::uint32_t cell)> &owned, const ContactOptions &options)
    : pairing_(mesh, pair, owned, options.margin), law_{pair.stiffness, pair.onset}, options_(options),
      friction_(pair.friction), viscous_velocity_(pair.viscous_velocity),
      n_primary_surfaces_(pair.primary.size()), friction_law_{pair.elastic_slip},
      stored_pressure_(pairing_.n_points(), 0.)
{
}

/// Largest change of a displacement since the last search, mm.
double ContactWork::moved(const State &state) const
{
  return std::transform_reduce(
      searched_.begin(), searched_.end(), state.displacement.begin(), 0.,
      [](double a, double b) { return std::max(a, b); }, [](double from, double to) { return std::abs(to - from); });
}

void ContactWork::search(const State &state)
{
  const std::size_t before = pairing_.couplings().size();
  pairing_.search(state.displacement);
  searched_ = state.displacement;
  couplings_changed_ = pairing_.couplings().size() > before;
}

void ContactWork::begin_step(const State &start, const Step &step)
{
  const bool had_couplings = !pairing_.couplings().empty();
  pairing_.begin_step();
  take_shifts(start);
  search(start);
  couplings_changed_ = couplings_changed_ || had_couplings;
  friction_law_.viscous_slip = viscous_velocity_ * step.rate_time();
  sliding_.clear();
  std::fill(stored_pressure_.begin(), stored_pressure_.end(), 0.);
  for (const PairedPoint &p : touching(start)) {
    stored_pressure_[p.index] = law_.pressure(p.shifted_penetration());
    if (const double strength = friction_ * stored_pressure_[p.index]; strength > 0) {
      const auto friction =
          friction_law_.begin(strength, p.area, p.closest.normal, remembered_traction(start, first_point_ + p.number));
      sliding_.push_back(sliding_point(pairing_, p, start.displacement, friction));
    }
  }
}

std::size_t ContactWork::number_points_from(std::size_t first)
{
  first_point_ = first;
  return first + pairing_.n_points_of_all_ranks();
}

std::size_t ContactWork::number_shifts_from(std::size_t first)
{
  first_shift_ = first;
  return first + pairing_.n_shifts();
}

void ContactWork::take_shifts(const State &state)
{
  pairing_.take_shifts(shifts_of_pair(state, first_shift_, pairing_.n_shifts()));
}

void ContactWork::add_gaps(const State &state, MeanGaps &gaps) const
{
  for (const PairedPoint &p : touching(state))
    gaps.add(pairing_.patches()[p.own], p.own_xi, first_shift_, p.area * law_.pressure(p.shifted_penetration()),
             p.penetration);
}

void ContactWork::end_step(State &end) const
{
  for (const SlidingPoint &s : sliding_) {
    FrictionPoint turned = s.friction;
    turned.elastic_slip = turn(s, pairing_, end.displacement) * turned.elastic_slip;
    const Point3 force = friction_law_.remembered_force(turned, slip(s, pairing_, end.displacement));
    remember_traction(end, first_point_ + s.contact.number, force / s.contact.area);
  }
}

void ContactWork::begin_iteration(const State &state, int iteration)
{
  couplings_changed_ = false;
  pairing_.allow_crossing(iteration < options_.crossing_iterations);
  if (moved(state) > (iteration < options_.search_iterations ? 0.05 : 0.5) * options_.margin)
    search(state);
}

void ContactWork::add_couplings(std::vector<std::vector<Node>> &sets) const
{
  for (const auto &[secondary, cell] : pairing_.couplings()) {
    const auto &nodes = pairing_.patches()[secondary].nodes;
    const auto &cell_nodes = pairing_.mesh().cells[cell];
    auto &set = sets.emplace_back(nodes.begin(), nodes.end());
    set.insert(set.end(), cell_nodes.begin(), cell_nodes.end());
  }
}

Point3 ContactWork::friction_force(const SlidingPoint &s, const State &state) const
{
  return friction_law_.force(s.friction, slip(s, pairing_, state.displacement));
}

double ContactWork::energy(const State &state) const
{
  double sum = 0;
  for (const PairedPoint &p : touching(state)) {
    sum += p.area * law_.energy(p.shifted_penetration());
  }
  for (const SlidingPoint &s : sliding_)
    sum += friction_law_.energy(s.friction, slip(s, pairing_, state.displacement));
  return sum;
}

void ContactWork::residual(const State &state, Assembly &assembly) const
{
  const auto &patches = pairing_.patches();
  ForceBuffer buffer(pairing_);
  for (const PairedPoint &p : touching(state)) {
    const Point3 force = p.area * law_.pressure(p.shifted_penetration()) * p.closest.normal;
    buffer.add(p.own, node_weights(patches[p.own], patch_shapes(p.own_xi).value), -force);
    buffer.add(p.patch, node_weights(patches[p.patch], patch_shapes(p.closest.xi).value), force);
  }
  for (const SlidingPoint &s : sliding_) {
    const Point3 force = friction_force(s, state);
    buffer.add(s.secondary.patch, s.secondary.weights, force);
    buffer.add(s.primary.patch, s.primary.weights, -force);
  }
  buffer.flush(assembly);
}

void ContactWork::tangent(const State &state, Assembly &assembly) const
{
  std::vector<NormalContact> normal;
  for (const PairedPoint &p : touching(state)) {
    const double stress = convex_ ? 0 : stored_pressure_[p.index];
    normal.push_back({p, p.area * law_.slope(p.shifted_penetration()), p.area * stress});
  }
  std::vector<SlidingContact> sliding;
  for (const SlidingPoint &s : sliding_)
    sliding.push_back({&s, friction_law_.tangent(s.friction, slip(s, pairing_, state.displacement))});
  add_contact_tangent(pairing_, normal, sliding, assembly);
}

void ContactWork::advance(const State &from, std::span<const double> increment, double fraction)
{
  std::fill(stored_pressure_.begin(), stored_pressure_.end(), 0.);
  const NodalField field = {increment};
  std::vector<PatchNodes> increments;
  for (const Patch &patch : pairing_.patches())
    increments.push_back(at_depth(patch, field));
  for (const PairedPoint &p : touching(from)) {
    const Point3 relative = interpolate(increments[p.own], patch_shapes(p.own_xi).value) -
                            interpolate(increments[p.patch], patch_shapes(p.closest.xi).value);
    const double predicted = law_.pressure(p.shifted_penetration()) -
                             law_.slope(p.shifted_penetration()) * fraction * (p.closest.normal * relative);
    stored_pressure_[p.index] = std::max(predicted, 0.);
  }
}

double ContactWork::largest_step(const State &state, std::span<const double> increment) const
{
  return largest_fraction(pairing_, state.displacement, increment);
}

ContactSummary ContactWork::summary(const State &state) const
{
  ContactSummary summary;
  summary.primary_force.resize(n_primary_surfaces_, Vector3{});
  auto add = [&](std::uint32_t primary, const Point3 &force_on_secondary) {
    summary.primary_force[pairing_.patches()[primary].surface] += -force_on_secondary;
    summary.secondary_force += force_on_secondary;
  };
  for (const PairedPoint &p : touching(state)) {
    const Point3 force = p.area * law_.pressure(p.shifted_penetration()) * p.closest.normal;
    if (pairing_.is_secondary(p.own))
      add(p.patch, force);
    else
      add(p.own, -force);
    summary.normal_force += force.norm();
    summary.area += p.area;
    summary.penetration = std::max(summary.penetration, p.penetration);
    ++summary.points;
  }
  for (const SlidingPoint &s : sliding_)
    add(s.primary.patch, -friction_force(s, state));
  return summary;
}

double ContactWork::missed_force(const State &state) const
{
  std::vector<bool> touches(pairing_.n_points(), false);
  for (const PairedPoint &p : touching(state)) {
    touches[p.index] = true;
  }
  ContactPairing afresh = pairing_;
  afresh.allow_crossing(true);
  afresh.search(state.displacement);
  double missed = 0;
  for (const PairedPoint &p : afresh.touching(state.displacement))
    if (!touches[p.index])
      missed += p.area * law_.pressure(p.shifted_penetration());
  return missed;
}

std::vector<ContactPoint> ContactWork::contact_points(const State &state) const
{
  std::vector<ContactPoint> points;
  for (const PairedPoint &p : touching(state)) {
    const Face own = pairing_.patches()[p.own].face, other = pairing_.patches()[p.patch].face;
    const Point3 closest = p.position - p.closest.distance * p.closest.normal;
    const bool felt_by_secondary = pairing_.is_secondary(p.own);
    points.push_back({felt_by_secondary ? own : other, felt_by_secondary ? other : own,
                      to_array(felt_by_secondary ? p.position : closest), p.area,
                      law_.pressure(p.shifted_penetration()), p.penetration});
  }
  return points;
}

} // namespace ballonet::solver
