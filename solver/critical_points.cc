// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/critical_points.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace ballonet::solver
{

using Prescribe = NewtonSolver::Prescribe;

namespace
{

double dot(const std::vector<double> &a, const std::vector<double> &b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

/// Whether the counts at held load, or only those at held volume, tell about the change.
bool at_held_load(const Stability &a, const Stability &b) { return a.negative_pivots != b.negative_pivots; }

/// The mode that becomes unstable between two states, or stable: on the side where it is unstable it is the first one
/// beyond those that are unstable on both. Elsewhere it is known by its shape.
class CriticalMode
{
public:
  CriticalMode(Equilibrium &equilibrium, const Station &a, const Station &b)
      : equilibrium_(equilibrium), load_held_(at_held_load(a.stability, b.stability)),
        number_(std::min(count(a.stability), count(b.stability)) + 1)
  {
    const auto &unstable = count(a.stability) > count(b.stability) ? a : b;
    shape_ = lowest(unstable.state, number_).at(number_ - 1).shape;
  }

  const std::vector<double> &shape() const { return shape_; }

  /// Of the mode there that is most alike, among the lowest ones.
  double eigenvalue(const State &state) const
  {
    constexpr int more = 5;
    const auto modes = lowest(state, number_ + more);
    const auto likeness = [&](const Mode &m) {
      return std::abs(dot(m.shape, shape_)) / std::sqrt(dot(m.shape, m.shape));
    };
    const auto less = [&](const Mode &m, const Mode &n) { return likeness(m) < likeness(n); };
    return std::max_element(modes.begin(), modes.end(), less)->omega_squared;
  }

private:
  int count(const Stability &s) const { return load_held_ ? s.negative_pivots : s.at_held_volume(); }
  std::vector<Mode> lowest(const State &state, int count) const
  {
    return equilibrium_.modes(state, {.count = count, .volume_held = !load_held_, .by_volume = true});
  }

  Equilibrium &equilibrium_;
  bool load_held_;
  int number_;
  std::vector<double> shape_;
};

CriticalKind kind_of_zero(const Stability &a, const Stability &b)
{
  if (!at_held_load(a, b))
    return CriticalKind::volume_limit;
  return a.at_held_volume() == b.at_held_volume() ? CriticalKind::limit_point : CriticalKind::bifurcation;
}

std::string text_of(const CriticalPoint &point)
{
  std::ostringstream line;
  line << "critical point in step " << point.step << ": " << word_of(point.kind) << " at p " << 1e3 * point.pressure
       << " kPa, volume " << point.volume << " mm^3, load factor " << point.load_factor << "; unstable motions "
       << point.before.negative_pivots << " -> " << point.after.negative_pivots << " (at held volume "
       << point.before.at_held_volume() << " -> " << point.after.at_held_volume() << "), eigenvalue "
       << point.eigenvalue[0] << " -> " << point.eigenvalue[1] << " MPa/mm^2 over " << point.bracket << " of the step";
  return line.str();
}

} // namespace

const char *word_of(CriticalKind kind)
{
  switch (kind) {
  case CriticalKind::limit_point:
    return "limit_point";
  case CriticalKind::volume_limit:
    return "volume_limit";
  case CriticalKind::bifurcation:
    return "bifurcation";
  case CriticalKind::eigenvalue_jump:
    return "eigenvalue_jump";
  case CriticalKind::unresolved:
    return "unresolved";
  }
  return "";
}

std::optional<Station> CriticalPointSearch::solve(State state, const Step &step, const NewtonSolver::Target &target)
{
  const auto outcome = equilibrium_.solve(state, step, target);
  if (!outcome.converged)
    return {};
  const Stability stability = equilibrium_.stability(state);
  return Station{std::move(state), outcome.volume, stability};
}

/// A static step to the middle: of volume, of load, or on the plane that halves the way at right angles.
std::optional<CriticalPointSearch::End> CriticalPointSearch::halfway(const End &a, const End &b, Prescribe what)
{
  const bool along_arc = what == Prescribe::arc_length;
  std::vector<double> way = b.state.displacement;
  std::transform(way.begin(), way.end(), a.state.displacement.begin(), way.begin(), std::minus<>());
  const NewtonSolver::Target target = {.what = what,
                                       .parameter = (a.state.pressure + b.state.pressure) / 2,
                                       .volume = (a.volume + b.volume) / 2,
                                       .arc_length = std::sqrt(dot(way, way)) / 2,
                                       .direction = way};
  const double load_factor = along_arc ? a.state.load_factor : (a.state.load_factor + b.state.load_factor) / 2;
  const auto middle = solve(a.state, {infinity, load_factor, false, false}, target);
  return middle ? std::optional<End>({*middle, (a.place + b.place) / 2}) : std::nullopt;
}

std::optional<Station> CriticalPointSearch::branch_off(const CriticalPoint &point, double amplitude)
{
  State state = point.state;
  for (std::size_t i = 0; i < point.mode.size(); ++i)
    state.displacement[i] += amplitude * point.mode[i];
  const Step step = {infinity, state.load_factor, false, false};
  return solve(std::move(state), step, {.what = Prescribe::arc_length, .direction = point.mode});
}

void CriticalPointSearch::narrow(End &a, End &b, Prescribe what)
{
  while (b.place - a.place > tolerance_) {
    auto middle = halfway(a, b, what);
    if (!middle)
      return;
    (middle->stability.same_counts(a.stability) ? a : b) = std::move(*middle);
  }
}

/// A mode has no sign of its own: it goes where the load pushes, or else its largest component is positive.
void CriticalPointSearch::orient(CriticalPoint &point) const
{
  const auto force = equilibrium_.load_force(point.state);
  const double work = dot(force, point.mode), size = std::sqrt(dot(force, force) * dot(point.mode, point.mode));
  point.load_participation = size > 0 ? std::abs(work) / size : 0;
  const double largest = *std::max_element(point.mode.begin(), point.mode.end(),
                                           [](double x, double y) { return std::abs(x) < std::abs(y); });
  const double sign = point.kind == CriticalKind::limit_point ? work : largest;
  if (sign < 0)
    for (double &value : point.mode)
      value = -value;
}

CriticalPoint CriticalPointSearch::describe(const End &a, const End &b, const End &first, const End &last)
{
  constexpr double widest = 0.125, still = 0.25; // change over so small a part of the step, of that over all of it
  const CriticalMode critical(equilibrium_, a, b);
  CriticalPoint point;
  point.state = a.state;
  point.mode = critical.shape();
  point.bracket = b.place - a.place;
  point.before = a.stability, point.after = b.stability;
  point.eigenvalue = {critical.eigenvalue(a.state), critical.eigenvalue(b.state)};
  const auto [before, after] = point.eigenvalue;
  const double change = critical.eigenvalue(last.state) - critical.eigenvalue(first.state);
  const bool vanishes = before * after <= 0 && std::abs(after - before) < still * std::abs(change);
  point.kind = point.bracket > widest ? CriticalKind::unresolved
               : vanishes             ? kind_of_zero(a.stability, b.stability)
                                      : CriticalKind::eigenvalue_jump;
  const double part = vanishes ? before / (before - after) : 0.5;
  point.pressure = std::lerp(a.state.pressure, b.state.pressure, part);
  point.volume = std::lerp(a.volume, b.volume, part);
  point.load_factor = std::lerp(a.state.load_factor, b.state.load_factor, part);
  orient(point);
  return point;
}

std::vector<CriticalPoint> CriticalPointSearch::between(const Station &from, const Station &to, Prescribe what,
                                                        int step, const Log &log)
{
  constexpr std::size_t most = 8;
  std::vector<CriticalPoint> points;
  End a = {from, 0};
  const End last = {to, 1};
  while (!a.stability.same_counts(last.stability) && points.size() < most) {
    End b = last;
    const End first = a;
    narrow(a, b, what);
    points.push_back(describe(a, b, first, last));
    points.back().step = step;
    log(text_of(points.back()));
    a = b;
  }
  return points;
}

} // namespace ballonet::solver
