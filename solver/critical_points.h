// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/equilibrium.h"
#include "solver/step_plan.h"
#include <functional>

namespace ballonet::solver
{

/// What happens where the number of unstable motions changes between two equilibria of a path.
enum class CriticalKind {
  limit_point,     ///< the load parameter has a maximum or minimum: the critical mode does work on the load
  volume_limit,    ///< the volume (without a cavity: the way of the load) has a maximum or minimum
  bifurcation,     ///< another branch crosses: the critical mode does no work on the load
  eigenvalue_jump, ///< no eigenvalue is zero, one jumps: contact opened, closed, or began to slide
  unresolved       ///< the bisection found no equilibria close to it
};
/// The word that is the kind's name here.
const char *word_of(CriticalKind kind);

struct CriticalPoint {
  CriticalKind kind = CriticalKind::limit_point;
  int step = 0;                       ///< in which it lies
  State state;                        ///< just before it
  double pressure = 0;                ///< MPa, where the critical eigenvalue vanishes between the two ends found
  double volume = 0, load_factor = 0; ///< likewise; mm^3
  double bracket = 0;                 ///< between which it lies: part of the step
  Stability before, after;            ///< at both ends of that bracket
  std::array<double, 2> eigenvalue{}; ///< of the mode at both ends; MPa/mm^2 (mass: volume at rest)
  double load_participation = 0;      ///< |F . mode| / (|F| |mode|)
  std::vector<double> mode;           ///< three per node; the node that moves most moves by 1
};

/// An equilibrium of a path.
struct Station {
  State state;
  double volume = 0; ///< mm^3
  Stability stability;
};

/// Finds the critical points between two equilibria that one static step has led through, by bisection in static steps
/// on the counts of unstable motions. Where a step of the bisection does not converge the bracket stays as wide as it
/// is. Whether an eigenvalue vanishes or jumps is told from how much that of the same mode still changes over the
/// bracket: hardly, compared with its change over the step, or as much.
class CriticalPointSearch
{
public:
  using Log = std::function<void(const std::string &)>;

  /// `tolerance`: width of the bracket, part of the step.
  CriticalPointSearch(Equilibrium &equilibrium, double tolerance) : equilibrium_(equilibrium), tolerance_(tolerance) {}

  /// `what` was prescribed in the step; all that Newton's tangents alone tell of stability is not enough here:
  /// `from` and `to` have that of Equilibrium::stability.
  std::vector<CriticalPoint> between(const Station &from, const Station &to, NewtonSolver::Prescribe what, int step,
                                     const Log &log);

  /// An equilibrium beside a critical point, off it by `amplitude` (mm) times its mode as measured along the mode; load
  /// and volume follow. Nothing when none is found.
  std::optional<Station> branch_off(const CriticalPoint &point, double amplitude);

private:
  struct End : Station {
    double place = 0; ///< between the two equilibria: 0 to 1
  };

  std::optional<Station> solve(State state, const Step &step, const NewtonSolver::Target &target);
  std::optional<End> halfway(const End &a, const End &b, NewtonSolver::Prescribe what);
  /// Narrows to the first change of the counts.
  void narrow(End &a, End &b, NewtonSolver::Prescribe what);
  CriticalPoint describe(const End &a, const End &b, const End &first, const End &last);
  void orient(CriticalPoint &point) const;

  Equilibrium &equilibrium_;
  double tolerance_;
};

} // namespace ballonet::solver
