// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "solver/place.h"
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

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

} // namespace

Equilibrium::Equilibrium(const Parameters &parameters, const Mesh &mesh, MPI_Comm comm)
    : parameters_(parameters), comm_(comm), discretization_(mesh, comm), system_(discretization_),
      contacts_(parameters, discretization_)
{
  build_bodies();
  if (parameters.cavity)
    cavity_ = std::make_unique<CavityWork>(discretization_, *parameters.cavity);

  for (const auto &body : bodies_)
    works_.push_back(body.get());
  for (const auto &load : loads_)
    works_.push_back(load.get());
  for (auto *contact : contacts_.works())
    works_.push_back(contact);
  works_.push_back(inertia_.get());
  if (cavity_)
    works_.push_back(cavity_.get());
  std::vector<VirtualWork *> loads;
  for (const auto &load : loads_)
    loads.push_back(load.get());
  newton_ = std::make_unique<NewtonSolver>(system_, works_, loads, cavity_.get(), comm, parameters.newton);
}

Equilibrium::~Equilibrium() = default;

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
  return {zeros, zeros, zeros, std::vector<double>(3 * contacts_.n_points()),
          0,     0,     0,     std::vector<double>(contacts_.augmentation().n_shifts())};
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
  auto outcome = solve_augmented(end, target);
  if (outcome.converged) {
    inertia_->end_step(end);
    contacts_.end_step(end);
    state = std::move(end);
  } else if (outcome.restless) {
    outcome.reason +=
        "; what moves most is " + place_of(discretization_.mesh(), *outcome.restless, end, parameters_.contact_pairs);
  }
  return outcome;
}

/// To equilibrium with augmented contact: again and again, as long as that is asked for.
NewtonSolver::Outcome Equilibrium::solve_augmented(State &end, const NewtonSolver::Target &target)
{
  const Augmentation &augmentation = contacts_.augmentation();
  augmentation.predict(end);
  auto outcome = newton_->solve(end, target);
  for (int k = 0; outcome.converged && augmentation.augment(end, k); ++k)
    outcome = newton_->go_on(end);
  if (outcome.converged)
    std::tie(outcome.mean_penetration, outcome.shortfall) = augmentation.remaining(end);
  return outcome;
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

} // namespace ballonet::solver
