// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/coupling_pattern.h"
#include "solver/matrix_factor.h"
#include "solver/virtual_work.h"
#include <functional>

namespace ballonet::solver
{

/// Displacements prescribed on nodes: value of every held equation (three per node), NaN where it is free.
using Prescribed = std::vector<double>;

/// The distributed system of one Newton iteration: symmetric block matrix (SBAIJ, blocks of 3), its factor, residual
/// and border. Held equations become unit rows; their prescribed increments enter the right-hand side, so the matrix
/// stays symmetric.
class LinearSystem
{
public:
  explicit LinearSystem(const Discretization &discretization);
  ~LinearSystem();
  LinearSystem(const LinearSystem &) = delete;
  LinearSystem &operator=(const LinearSystem &) = delete;

  /// Which equations are held, and where they shall be.
  void prescribe(const Prescribed &values) { prescribed_ = values; }

  /// Makes room for the couplings of this rank beyond the cells' own, see CouplingPattern (collective).
  void couple(const std::vector<std::vector<Node>> &couplings)
  {
    pattern_changed_ = pattern_.cover(couplings) || pattern_changed_;
  }

  /// Calls `add` with an assembly for residuals and sums what it adds over the ranks.
  void assemble(const std::function<void(Assembly &)> &add, Vec sum) const;
  /// Replaces the held equations of a residual by u - prescribed; returns the largest of them over all ranks.
  double hold(const State &state, Vec residual) const;
  /// Sets the held entries to zero and returns the norm of what stood there.
  double clear_held(Vec vector) const;
  /// Sum of their tangents, factorised. False when MUMPS fails.
  bool factorise(const std::vector<VirtualWork *> &works, const State &state);
  /// Sum of their tangents, to be solved with by GMRES with the last factor as its preconditioner; it gets a factor of
  /// its own where that converges too slowly to be worth while.
  void precondition(const std::vector<VirtualWork *> &works, const State &state);
  /// Leaves the last factor as it is for further solutions in which every held value is met.
  void keep_factor();
  /// So far.
  int factorisations() const { return factor_.computed(); }
  /// Number of negative pivots of the last factorisation.
  int negative_pivots() const { return factor_.negative_pivots(); }
  /// x = K^-1 b where the held entries of b are zero.
  void solve(Vec b, Vec x) { factor_.solve(b, x); }
  /// The same for a residual whose held entries are u - prescribed.
  void solve_held(Vec b, Vec x);

  Vec create_vector() const;
  /// Distributed vector from a replicated field and back (collective).
  void scatter(const std::vector<double> &field, Vec vector) const;
  void gather(Vec vector, std::vector<double> &field) const;

private:
  class ResidualAssembly;
  class TangentAssembly;
  void rebuild_pattern();
  void sum_tangents(const std::vector<VirtualWork *> &works, const State &state);
  /// Calls `visit(local index, prescribed value, displacement index)` for every held equation of this rank.
  template <class Visit>
  void for_held(const Visit &visit) const;

  const Discretization &discretization_;
  Prescribed prescribed_;
  CouplingPattern pattern_;
  Mat matrix_ = nullptr;
  MatrixFactor factor_;
  Vec lift_ = nullptr; ///< K_fc (u_c - prescribed_c)
  mutable Vec sequential_ = nullptr;
  VecScatter to_all_ = nullptr;
  bool pattern_changed_ = true;
};

} // namespace ballonet::solver
