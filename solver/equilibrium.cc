// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "solver/free_surface.h"
#include "solver/penetration_check.h"
#include "solver/rigid_penetration.h"
#include "solver/self_penetration.h"
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace ballonet::solver
{

namespace
{

template <class List>
const auto &named(const List &list, const std::string &name, const char *what)
{
  for (const auto &item : list)
    if (item.name == name)
      return item;
  throw std::invalid_argument(std::string("there is no ") + what + " \"" + name + "\"");
}

template <class List, class Item>
bool in(const List &list, const Item &item)
{
  return std::find(list.begin(), list.end(), item) != list.end();
}

} // namespace

Equilibrium::Equilibrium(const Parameters &parameters, const Mesh &mesh, MPI_Comm comm)
    : parameters_(parameters), comm_(comm), discretization_(mesh, comm), system_(discretization_)
{
  build_bodies();
  for (const auto &pair : parameters.contact_pairs) {
    build_contact(pair);
    n_contact_points_ = contacts_.back()->number_points_from(n_contact_points_);
  }
  if (parameters.cavity)
    cavity_ = std::make_unique<CavityWork>(discretization_, *parameters.cavity);

  for (const auto &body : bodies_)
    works_.push_back(body.get());
  for (const auto &load : loads_)
    works_.push_back(load.get());
  for (const auto &contact : contacts_)
    works_.push_back(contact.get());
  works_.push_back(inertia_.get());
  if (cavity_)
    works_.push_back(cavity_.get());
  std::vector<VirtualWork *> loads;
  for (const auto &load : loads_)
    loads.push_back(load.get());
  newton_ = std::make_unique<NewtonSolver>(system_, works_, loads, cavity_.get(), comm, parameters.newton);
}

Equilibrium::~Equilibrium() = default;

void Equilibrium::build_contact(const ContactPair &pair)
{
  const Mesh &mesh = discretization_.mesh();
  const auto owned = [this](std::uint32_t cell) { return discretization_.owns(cell); };
  for (const RigidBody &body : parameters_.rigid_bodies)
    if (in(pair.primary, body.name)) {
      contacts_.push_back(std::make_unique<RigidContactWork>(mesh, pair, body, owned));
      add_check<RigidPenetration>(mesh, pair, body, pair.penetration_limit);
      return;
    }
  contacts_.push_back(std::make_unique<ContactWork>(mesh, pair, owned));
  build_checks(pair);
}

template <class Check, class... Arguments>
void Equilibrium::add_check(const Arguments &...arguments)
{
  checks_.push_back([check = std::make_shared<const Check>(arguments...)](const State &s) { return check->find(s); });
}

/// For deformable bodies: those on one side of the pair, and those on both.
void Equilibrium::build_checks(const ContactPair &pair)
{
  const Mesh &mesh = discretization_.mesh();
  const Flags secondary = bodies_of(mesh, pair.secondary), primary = bodies_of(mesh, pair.primary);
  if (secondary != primary)
    add_check<PenetrationCheck>(mesh, pair, pair.penetration_limit);
  if (in(both(secondary, primary), true))
    add_check<SelfPenetration>(mesh, pair, pair.penetration_limit);
}

/// The bodies, and what follows from their masses.
void Equilibrium::build_bodies()
{
  std::vector<double> mass(discretization_.n_nodes()), damping = mass;
  const auto &names = discretization_.mesh().bodies;
  for (std::uint32_t b = 0; b < names.size(); ++b) {
    const auto &body = named(parameters_.bodies, names[b], "body");
    const auto &material = named(parameters_.materials, body.material, "material");
    bodies_.push_back(std::make_unique<ElasticWork>(discretization_, b, make_material(material),
                                                    material.relaxation_time, body.mixed));
    add_nodal_mass(discretization_, b, material.density, mass);
    add_nodal_mass(discretization_, b, material.density * material.mass_damping, damping);
  }
  build_loads(mass);
  inertia_ = std::make_unique<InertiaWork>(std::move(mass), std::move(damping), step_rule(parameters_.path));
}

void Equilibrium::build_loads(const std::vector<double> &mass)
{
  loads_.push_back(std::make_unique<DeadLoad>(discretization_, mass, parameters_.gravity, parameters_.loads));
  for (const auto &load : parameters_.loads)
    if (load.pressure != 0)
      loads_.push_back(std::make_unique<FollowerLoad>(discretization_, load));
}

State Equilibrium::initial_state() const
{
  const std::vector<double> zeros(3 * discretization_.n_nodes());
  return {zeros, zeros, zeros, std::vector<double>(3 * n_contact_points_), 0, 0};
}

/// Nodal masses, t, summed over the ranks.
std::vector<double> Equilibrium::total_mass() const
{
  auto mass = inertia_->mass();
  MPI_Allreduce(MPI_IN_PLACE, mass.data(), mass.size(), MPI_DOUBLE, MPI_SUM, comm_);
  if (std::all_of(mass.begin(), mass.end(), [](double m) { return m == 0; }))
    throw std::invalid_argument("free motion needs mass; no material has a density");
  return mass;
}

/// Volume at rest that a node stands for, mm^3, summed over the ranks.
std::vector<double> Equilibrium::nodal_volumes() const
{
  std::vector<double> volumes(discretization_.n_nodes());
  for (std::uint32_t body = 0; body < bodies_.size(); ++body)
    add_nodal_mass(discretization_, body, 1, volumes);
  MPI_Allreduce(MPI_IN_PLACE, volumes.data(), volumes.size(), MPI_DOUBLE, MPI_SUM, comm_);
  return volumes;
}

bool Equilibrium::moves_a_support() const
{
  return std::any_of(parameters_.supports.begin(), parameters_.supports.end(), [](const Support &support) {
    return std::any_of(support.move.begin(), support.move.end(), [](const auto &way) { return way && *way != 0; });
  });
}

bool Equilibrium::feels_rates() const
{
  const auto any = [](const auto &list, const auto &condition) {
    return std::any_of(list.begin(), list.end(), condition);
  };
  const bool inertia = parameters_.path.inertia;
  return any(parameters_.materials,
             [&](const Material &m) { return m.relaxation_time > 0 || (inertia && m.density > 0); }) ||
         any(parameters_.contact_pairs,
             [](const ContactPair &p) { return p.friction > 0 && p.viscous_velocity < infinity; });
}

void Equilibrium::release(State &state)
{
  const Prescribed held = prescribed(1);
  if (moves_a_support())
    throw std::invalid_argument("path.control = \"release\" lets go of a body at rest; it cannot move a support");
  const auto mass = total_mass();
  state.load_factor = 1;
  for (auto *work : works_)
    work->begin_step(state, {.dt = infinity});
  const auto forces = newton_->forces(state);
  for (std::size_t i = 0; i < forces.size(); ++i)
    state.acceleration[i] = std::isnan(held[i]) && mass[i / 3] > 0 ? -forces[i] / mass[i / 3] : 0;
}

Prescribed Equilibrium::prescribed(double load_factor) const
{
  Prescribed values(3 * discretization_.n_nodes(), std::nan(""));
  for (const auto &support : parameters_.supports)
    for (const auto node : nodes_of_place(discretization_.mesh(), support.surface, support.nodes)) {
      for (const auto &direction : support.fix)
        values[3 * node + direction[0] - 'x'] = 0;
      for (int d = 0; d < 3; ++d)
        if (support.move[d])
          values[3 * node + d] = load_factor * *support.move[d];
    }
  return values;
}

NewtonSolver::Outcome Equilibrium::solve(State &state, const Step &step, const NewtonSolver::Target &target)
{
  if (target.what == NewtonSolver::Prescribe::arc_length && !cavity_ && moves_a_support())
    throw std::invalid_argument("path.control = \"arc_length\" follows the load factor of loads; it cannot move a "
                                "support (that is control = \"load\")");
  system_.prescribe(prescribed(step.load_factor));
  for (auto *work : works_)
    work->begin_step(state, step);
  State end = state;
  end.load_factor = step.load_factor;
  auto outcome = newton_->solve(end, target);
  if (outcome.converged) {
    inertia_->end_step(end);
    remember_friction(end);
    state = std::move(end);
  } else if (outcome.restless) {
    outcome.reason += "; what moves most is " + place_of(*outcome.restless, end);
  }
  return outcome;
}

/// A node in words: where it is, in which body, on which surfaces of contact pairs.
std::string Equilibrium::place_of(Node node, const State &state) const
{
  const Mesh &mesh = discretization_.mesh();
  const auto cell =
      std::find_if(mesh.cells.begin(), mesh.cells.end(), [&](const auto &nodes) { return in(nodes, node); });
  std::ostringstream text;
  text.precision(4);
  text << "body \"" << mesh.bodies[mesh.cell_body[cell - mesh.cells.begin()]] << "\" at (";
  for (int d = 0; d < 3; ++d)
    text << mesh.nodes[node][d] + state.displacement[3 * node + d] << (d < 2 ? ", " : ") mm, element ");
  text << cell - mesh.cells.begin();
  for (const auto &pair : parameters_.contact_pairs)
    for (const Surface &surface : mesh.surfaces)
      if (in(pair.secondary, surface.name) || in(pair.primary, surface.name))
        if (const auto nodes = surface_nodes(mesh, surface.name); in(nodes, node))
          text << ", on \"" << surface.name << "\" of contact pair \"" << pair.name << '"';
  return text.str();
}

void Equilibrium::remember_friction(State &end) const
{
  end.friction.assign(3 * n_contact_points_, 0.);
  for (const auto &contact : contacts_)
    contact->end_step(end);
  MPI_Allreduce(MPI_IN_PLACE, end.friction.data(), end.friction.size(), MPI_DOUBLE, MPI_SUM, comm_);
}

/// The tangent of a step of that length that starts at `state`, there.
void Equilibrium::factorise_tangent(const State &state, double dt)
{
  system_.prescribe(prescribed(state.load_factor));
  std::vector<std::vector<Node>> couplings;
  for (auto *work : works_) {
    work->begin_step(state, {.dt = dt});
    work->begin_iteration(state, 0);
    work->add_couplings(couplings);
  }
  system_.couple(couplings);
  if (!system_.factorise(works_, state))
    throw std::runtime_error("the factorisation of the tangent failed");
}

Stability Equilibrium::stability(const State &state)
{
  factorise_tangent(state, infinity);
  const bool has_load = cavity_ || !parameters_.loads.empty() || parameters_.gravity != Vector3{};
  return {system_.negative_pivots(), has_load ? newton_->compliance(state) : 0};
}

std::vector<Mode> Equilibrium::modes(const State &state, const ModeRequest &request)
{
  if (request.volume_held && !cavity_)
    throw std::invalid_argument("modes at held volume need a cavity");
  const auto mass = request.by_volume ? nodal_volumes() : total_mass();
  factorise_tangent(state, request.dt);
  if (!request.volume_held)
    return lowest_modes(system_, mass, nullptr, request.count);
  Vec gradient = system_.create_vector();
  system_.assemble([&](Assembly &assembly) { cavity_->volume_gradient(state, assembly); }, gradient);
  system_.clear_held(gradient);
  auto found = lowest_modes(system_, mass, gradient, request.count);
  VecDestroy(&gradient);
  return found;
}

Energies Equilibrium::energies(const State &state) const
{
  Energies e;
  for (const auto &body : bodies_) {
    e.stored += body->stored_energy(state);
    e.dissipated += body->dissipated(state);
  }
  e.dissipated += inertia_->dissipated(state);
  e.kinetic = inertia_->kinetic_energy(state);
  MPI_Allreduce(MPI_IN_PLACE, &e, 3, MPI_DOUBLE, MPI_SUM, comm_);
  return e;
}

std::vector<double> Equilibrium::stresses(const State &state) const
{
  std::vector<double> stress(discretization_.mesh().cells.size());
  for (const auto &body : bodies_)
    body->stresses(state, stress);
  MPI_Allreduce(MPI_IN_PLACE, stress.data(), stress.size(), MPI_DOUBLE, MPI_MAX, comm_);
  return stress;
}

std::vector<ContactSummary> Equilibrium::contact(const State &state) const
{
  std::vector<ContactSummary> summaries;
  for (const auto &contact : contacts_) {
    auto s = contact->summary(state);
    std::vector<double> sums = {s.area, static_cast<double>(s.points), s.normal_force};
    sums.insert(sums.end(), s.secondary_force.begin(), s.secondary_force.end());
    for (const auto &force : s.primary_force)
      sums.insert(sums.end(), force.begin(), force.end());
    MPI_Allreduce(MPI_IN_PLACE, sums.data(), sums.size(), MPI_DOUBLE, MPI_SUM, comm_);
    MPI_Allreduce(MPI_IN_PLACE, &s.penetration, 1, MPI_DOUBLE, MPI_MAX, comm_);
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

std::vector<std::vector<ContactPoint>> Equilibrium::contact_points(const State &state) const
{
  std::vector<std::vector<ContactPoint>> points;
  for (const auto &contact : contacts_)
    points.push_back(contact->contact_points(state));
  return points;
}

/// Contact that a new search finds in a converged state, and that its equations do not know.
std::string Equilibrium::missed_contact(const State &state, const std::vector<ContactSummary> &summaries) const
{
  constexpr double share = 0.02; // of the normal force that is allowed to be missed
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    double missed = contacts_[i]->missed_force(state);
    MPI_Allreduce(MPI_IN_PLACE, &missed, 1, MPI_DOUBLE, MPI_SUM, comm_);
    if (missed > share * std::max(summaries[i].normal_force, parameters_.newton.force_floor))
      return "contact pair \"" + parameters_.contact_pairs[i].name + "\": a new search finds " +
             std::to_string(missed) + " N more normal force than the present pairs carry";
  }
  return {};
}

std::string Equilibrium::objection(const State &state) const
{
  const auto summaries = contact(state);
  if (const auto missed = missed_contact(state, summaries); !missed.empty())
    return missed;
  for (std::size_t i = 0; i < summaries.size(); ++i)
    if (const auto &pair = parameters_.contact_pairs[i]; summaries[i].penetration > pair.penetration_limit)
      return "contact pair \"" + pair.name + "\" penetrates by " + std::to_string(summaries[i].penetration) +
             " mm, allowed are " + std::to_string(pair.penetration_limit);
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
