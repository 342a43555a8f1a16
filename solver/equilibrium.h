// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairs.h"
#include "solver/elastic_work.h"
#include "solver/inertia_work.h"
#include "solver/load_work.h"
#include "solver/modes.h"
#include "solver/newton.h"
#include "solver/parameters.h"
#include <memory>

namespace ballonet::solver
{

/// Energies of a state, N mm, summed over the ranks.
struct Energies {
  double stored = 0;     ///< elastic
  double dissipated = 0; ///< by viscosity and mass damping, since the start of the step
  double kinetic = 0;
};

/// The mechanical system: all contributions to the virtual work, and the solver that balances them.
class Equilibrium
{
public:
  /// `parameters` and `mesh` must outlive this object. Throws std::invalid_argument for names the mesh does not have.
  Equilibrium(const Parameters &parameters, const Mesh &mesh, MPI_Comm comm);
  ~Equilibrium();

  State initial_state() const;
  /// Lets the body go: the state gets the acceleration that follows from the forces out of balance when gravity and
  /// loads act in full. Throws std::invalid_argument where there is no mass or a support is moved (it would have to
  /// jump).
  void release(State &state);
  const Discretization &discretization() const { return discretization_; }
  int factorisations() const { return system_.factorisations(); } ///< so far
  bool has_cavity() const { return cavity_ != nullptr; }

  /// Balances `state` at the end of a step that starts there, velocity and acceleration included. On failure `state`
  /// is what it was.
  NewtonSolver::Outcome solve(State &state, const Step &step, const NewtonSolver::Target &target);

  /// All contact pairs, and what they say of a state.
  const ContactPairs &contacts() const { return contacts_; }

  /// Lowest natural frequencies and shapes about an equilibrium, which may be unstable (collective). Throws
  /// std::runtime_error when they cannot be found, std::invalid_argument where there is no mass, or no volume to hold.
  std::vector<Mode> modes(const State &state, const ModeRequest &request);

  /// Whether anything resists a motion: viscosity, mass under the path's inertia, friction that feels the speed.
  bool feels_rates() const;

  /// Of the static tangent in a state, which is factorised there (collective).
  Stability stability(const State &state);
  std::vector<double> load_force(const State &state) const { return newton_->load_force(state); }

  double volume(const State &state) const { return newton_->volume(state); }
  Energies energies(const State &state) const;
  /// Largest von Mises stress of every cell of the mesh, MPa, on every rank.
  std::vector<double> stresses(const State &state) const;
  /// Force every node receives from outside at equilibrium, N, three per node: reactions of supports.
  std::vector<double> reactions(const State &state) const { return newton_->forces(state); }

private:
  void build_bodies();
  void build_loads(const std::vector<double> &mass);
  std::vector<double> total_mass() const;
  std::vector<double> nodal_volumes() const;
  NewtonSolver::Outcome solve_augmented(State &end, const NewtonSolver::Target &target);
  void factorise_tangent(const State &state, double dt);
  bool moves_a_support() const;
  Prescribed prescribed(double load_factor) const;

  const Parameters &parameters_;
  MPI_Comm comm_;
  Discretization discretization_;
  LinearSystem system_;
  std::vector<std::unique_ptr<ElasticWork>> bodies_;
  std::vector<std::unique_ptr<VirtualWork>> loads_;
  std::unique_ptr<CavityWork> cavity_;
  std::unique_ptr<InertiaWork> inertia_;
  ContactPairs contacts_;
  std::vector<VirtualWork *> works_; ///< all of the above
  std::unique_ptr<NewtonSolver> newton_;
};

} // namespace ballonet::solver
