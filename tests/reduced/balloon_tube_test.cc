// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/balloon_tube.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver::reduced;
using reference::kPa;

namespace
{

/// Pressure and wall force by Simpson's rule over the reference radius, from the Cauchy stresses of W = C10 (I1 - 3):
/// the radial stress falls by (s_hoop - s_r) / r, and s_z - s_r = mu (z^2 - l_r^2).
struct Quadrature {
  double pressure = 0, reduced_force = 0;
};

Quadrature integrate_stress(const Balloon &balloon, double z, double b)
{
  const double B = balloon.diameter / 2, A = B - balloon.wall, mu = 2 * balloon.c10;
  const auto radius = [&](double R) { return std::sqrt(b * b - (B * B - R * R) / z); };
  const auto pressure_slope = [&](double R) { // d s_r / d R
    const double hoop = radius(R) / R, radial = 1 / (hoop * z);
    return mu * (hoop * hoop - radial * radial) / radius(R) * radial;
  };
  constexpr int n = 2000;
  const double h = (B - A) / n;
  Quadrature result;
  double stress = 0; // radial, from the outside inwards
  for (int i = n; i > 0; --i) {
    const double R = A + (i - 0.5) * h;
    const double fall = h / 6 * (pressure_slope(R - h / 2) + 4 * pressure_slope(R) + pressure_slope(R + h / 2));
    const double middle = stress - h / 2 * pressure_slope(R + h / 4);
    const double hoop = radius(R) / R, axial = middle + mu * (z * z - 1 / (hoop * hoop * z * z));
    result.reduced_force += 2 * std::numbers::pi * R * h / z * axial; // area in the current section
    stress -= fall;
  }
  result.pressure = -stress;
  const double a = radius(A);
  result.reduced_force -= result.pressure * std::numbers::pi * a * a;
  return result;
}

Balloon with(double diameter, double wall, double c10)
{
  Balloon balloon;
  balloon.diameter = diameter;
  balloon.wall = wall;
  balloon.c10 = c10;
  return balloon;
}

} // namespace

TEST_CASE("pressure and reduced force are the integrals of the stress")
{
  const Balloon balloon = with(7.2, 0.5, 0.16);
  const BalloonTube tube(balloon);
  for (const auto &[z, b] : {std::pair{1.0, 3.7}, {0.97, 4.5}, {1.2, 6.0}, {1.6, 8.0}}) {
    const Quadrature exact = integrate_stress(balloon, z, b);
    CHECK(tube.pressure(z, b) == Approx(exact.pressure).epsilon(1e-6));
    CHECK(tube.reduced_force(z, b) == Approx(exact.reduced_force).epsilon(1e-5));
  }
}

TEST_CASE("the derivatives of the tube are those of its pressure and force")
{
  const BalloonTube tube(with(7.2, 0.5, 0.16));
  const double h = 1e-6;
  for (const auto &[z, b] : {std::pair{1.01, 3.9}, {1.2, 6.0}, {1.6, 8.0}}) {
    const auto wall_force = [&, b = b](double stretch) {
      const double a = tube.inner_radius(stretch, b);
      return tube.reduced_force(stretch, b) + tube.pressure(stretch, b) * std::numbers::pi * a * a;
    };
    CHECK(tube.pressure_per_radius(z, b) ==
          Approx((tube.pressure(z, b + h) - tube.pressure(z, b - h)) / (2 * h)).epsilon(1e-6));
    CHECK(tube.axial_stiffness(z, b) == Approx((wall_force(z + h) - wall_force(z - h)) / (2 * h)).epsilon(1e-6));
  }
}

TEST_CASE("limit pressures of free balloons")
{
  struct Case {
    double diameter, wall, c10, thin, thick, radius, stretch;
  };
  const Case cases[] = {{7.2, 0.5, 0.16, 35.81, 35.88, 5.415, 1.178}, {8.2, 0.5, 0.16, 31.16, 31.20, 6.204, 1.178},
                        {8.0, 0.5, 0.16, 31.99, 32.04, 6.044, 1.178}, {5.6, 0.5, 0.16, 47.05, 47.19, 4.155, 1.178},
                        {2.8, 0.5, 0.16, 104.3, 105.9, 1.941, 1.176}, {7.2, 1.0, 0.16, 77.4, 78.1, 5.151, 1.178},
                        {7.2, 0.5, 0.12, 26.86, 26.91, 5.415, 1.178}};
  for (const Case &c : cases) {
    const Balloon balloon = with(c.diameter, c.wall, c.c10);
    const auto limit = BalloonTube(balloon).limit();
    CHECK(thin_limit_pressure(balloon) == Approx(c.thin * kPa).epsilon(6e-4));
    CHECK(limit.pressure == Approx(c.thick * kPa).epsilon(8e-4));
    // The place of a flat maximum: not to all of the table's digits.
    CHECK(limit.outer_radius == Approx(c.radius).epsilon(1.5e-3));
    CHECK(limit.axial_stretch == Approx(c.stretch).epsilon(1.5e-3));
  }
  const Balloon standard = with(7.2, 0.5, 0.16);
  CHECK(thin_limit_pressure(standard) == Approx(0.7499 * 0.32 * 0.5 / 3.35).epsilon(1e-4));
}

TEST_CASE("free growth below the limit and on the falling branch")
{
  const BalloonTube tube(with(7.2, 0.5, 0.16));
  const std::pair<double, double> growth[] = {{10, 3.784}, {20, 4.036}, {25, 4.212}, {30, 4.462}, {34, 4.818}};
  for (const auto &[pressure, radius] : growth)
    CHECK(tube.free_state(radius).pressure == Approx(pressure * kPa).epsilon(2e-3));
  CHECK(90 * (tube.free_state(4.462).axial_stretch - 1) == Approx(4.17).epsilon(2e-3));
  CHECK(tube.free_state(8).pressure == Approx(28.07 * kPa).epsilon(2e-4));
  CHECK(tube.free_state(8).axial_stretch == Approx(1.686).epsilon(3e-4));
  CHECK(tube.free_state_at_stretch(96.0 / 90)->pressure == Approx(32.46 * kPa).epsilon(2e-4));
  CHECK_FALSE(tube.free_state_at_stretch(1.19));
}

TEST_CASE("confined balloon: hoop pressure and reduced force")
{
  const BalloonTube tube(with(7.2, 0.5, 0.16));
  const double table[][3] = {{96.0 / 90, 43.6, -5.45}, {1.2, 39.0, -3.97}, {1.3, 36.1, -3.00},
                             {1.4, 33.6, -2.13},       {1.5, 31.5, -1.33}, {1.7, 27.8, 0.10}};
  for (const auto &[z, pressure, force] : table) {
    CHECK(tube.pressure(z, 8) == Approx(pressure * kPa).margin(0.06 * kPa));
    CHECK(tube.reduced_force(z, 8) == Approx(force).margin(0.012));
  }
}

TEST_CASE("radius at a given thrust")
{
  const BalloonTube tube(with(7.2, 0.5, 0.16));
  const auto b = tube.radius_at_thrust(1.1, 0.05, 8);
  REQUIRE(b);
  CHECK(tube.thrust(1.1, *b, 0) == Approx(0.05));
  CHECK_FALSE(tube.radius_at_thrust(1.1, 100, 8));
  CHECK_FALSE(tube.radius_at_thrust(1.1, -100, 8));
}
