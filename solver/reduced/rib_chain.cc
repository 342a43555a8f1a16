// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/rib_chain.h"
#include "solver/reduced/tridiagonal.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver::reduced
{
namespace
{

using std::numbers::pi;

double ring_area(double outer, double inner) { return pi * (outer * outer - inner * inner); }

/// Adds a mass whose centre lies `along` and `across`.
void add(Unit &unit, double mass, double along, double across)
{
  const double total = unit.mass + mass;
  if (total <= 0)
    return;
  unit.along = (unit.mass * unit.along + mass * along) / total;
  unit.across = (unit.mass * unit.across + mass * across) / total;
  unit.mass = total;
}

double rib_mass(const Parameters &p)
{
  const double volume = ring_area(p.outer_radius(), p.ribs.inner_radius) * p.ribs.width;
  return p.ribs.mass.value_or(p.wall.density * volume);
}

double head_mass(const Parameters &p)
{
  return p.head.mass.value_or(p.wall.density * ring_area(p.outer_radius(), 0) * p.head.thickness);
}

double balloon_mass(const Balloon &b)
{
  return b.density * ring_area(b.diameter / 2, b.diameter / 2 - b.wall) * b.length;
}

std::vector<Unit> make_units(const Parameters &p, const Hinge &hinge, Load load)
{
  Unit unit;
  add(unit, rib_mass(p), p.pitch() / 2, hinge.lever);
  add(unit, p.wall.density * p.wall.width * p.wall.thickness * hinge.fold_length, p.pitch() / 2, 0);
  if (load == Load::with_balloon)
    add(unit, balloon_mass(p.balloon) / p.ribs.count, p.pitch() / 2, hinge.lever);
  std::vector<Unit> units(static_cast<std::size_t>(p.ribs.count), unit);
  add(units.back(), head_mass(p), (p.pitch() + p.ribs.width + p.head.thickness) / 2, hinge.lever);
  const double middle_radius = p.ribs.inner_radius + p.ribs.thickness / 2;
  double above = 0;
  for (std::size_t i = units.size(); i-- > 0;) {
    units[i].mass_above = above;
    units[i].rotary = units[i].mass * middle_radius * middle_radius / 2;
    above += units[i].mass;
  }
  return units;
}

} // namespace

RibChain::RibChain(const Parameters &parameters, const Hinge &hinge, Load load)
    : pitch_(parameters.pitch()), gravity_(parameters.gravity), units_(make_units(parameters, hinge, load))
{
}

double RibChain::gravity_force(std::size_t i, double al) const
{
  const Unit &u = units_[i];
  return gravity_ * (u.mass * u.across * std::cos(al) - (u.mass_above * pitch_ + u.mass * u.along) * std::sin(al));
}

double RibChain::gravity_stiffness(std::size_t i, double al) const
{
  const Unit &u = units_[i];
  return -gravity_ * (u.mass * u.across * std::sin(al) + (u.mass_above * pitch_ + u.mass * u.along) * std::cos(al));
}

std::vector<double> RibChain::residual(const Angles &al, double k) const
{
  const std::vector<double> th = gap_angles(al);
  std::vector<double> r(size());
  for (std::size_t i = 0; i < size(); ++i)
    r[i] = k * (th[i] - (i + 1 < size() ? th[i + 1] : 0)) + gravity_force(i, al[i]);
  return r;
}

std::vector<double> RibChain::tangent_diagonal(const Angles &al, double k) const
{
  std::vector<double> diagonal(size());
  for (std::size_t i = 0; i < size(); ++i)
    diagonal[i] = (i + 1 < size() ? 2 * k : k) + gravity_stiffness(i, al[i]);
  return diagonal;
}

bool RibChain::relax(Angles &al, double k, double weight, bool tip_is_held) const
{
  const std::size_t n = tip_is_held ? size() - 1 : size();
  for (int iteration = 0; iteration < 60; ++iteration) {
    std::vector<double> r = residual(al, k), diagonal = tangent_diagonal(al, k);
    for (std::size_t i = 0; i < n; ++i) {
      r[i] -= (1 - weight) * gravity_force(i, al[i]);
      diagonal[i] -= (1 - weight) * gravity_stiffness(i, al[i]);
    }
    const std::vector<double> step = solve_tridiagonal({diagonal.data(), n}, -k, {r.data(), n}).x;
    double largest = 0;
    for (double s : step)
      largest = std::max(largest, std::abs(s));
    const double shortening = std::min(1.0, 0.3 / largest); // rad
    for (std::size_t i = 0; i < n; ++i)
      al[i] -= shortening * step[i];
    if (largest < 1e-12)
      return true;
  }
  return false;
}

std::optional<Angles> RibChain::droop(double k) const
{
  constexpr int n_steps = 10;
  Angles al(size(), 0);
  for (int i = 1; i <= n_steps; ++i)
    if (!relax(al, k, static_cast<double>(i) / n_steps, false))
      return {};
  const bool stable = solve_tridiagonal(tangent_diagonal(al, k), -k, al).negative_pivots == 0;
  return stable ? std::optional(al) : std::nullopt;
}

std::optional<RibChain::Held> RibChain::hold(double tip_angle, double k, Angles guess) const
{
  const double turn = (tip_angle - guess.back()) / static_cast<double>(size());
  for (std::size_t i = 0; i < size(); ++i)
    guess[i] += turn * static_cast<double>(i + 1);
  guess.back() = tip_angle;
  if (!relax(guess, k, 1, true))
    return {};
  const double moment = residual(guess, k).back();
  return Held{std::move(guess), moment};
}

std::vector<double> gap_angles(const Angles &al)
{
  std::vector<double> th(al);
  for (std::size_t i = al.size(); i-- > 1;)
    th[i] -= th[i - 1];
  return th;
}

double self_weight_number(const RibChain &chain, double k, double gravity)
{
  const double height = static_cast<double>(chain.size()) * chain.pitch();
  return chain.moving_mass() * gravity * height * height / (k * chain.pitch());
}

} // namespace ballonet::solver::reduced
