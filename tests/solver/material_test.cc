// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/material.h"
#include <catch2/catch.hpp>
#include <functional>
#include <random>

using namespace ballonet::solver;

namespace
{

Material neo_hookean()
{
  Material m;
  m.name = "rubber", m.c10 = 0.16, m.d1 = 0.02;
  return m;
}

Material by_moduli(Law law)
{
  Material m;
  m.name = "plastic", m.law = law, m.youngs_modulus = 180, m.poisson_ratio = 0.4;
  return m;
}

const std::vector<Material> all_materials = {neo_hookean(), by_moduli(Law::neo_hookean), by_moduli(Law::saint_venant)};

Matrix3 random_deformation(unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-0.25, 0.25);
  Matrix3 F = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (double &x : F)
    x += value(generator);
  return F;
}

Matrix3 times(const Matrix3 &a, const Matrix3 &b)
{
  Matrix3 c{};
  for (int i = 0; i < 9; ++i)
    for (int k = 0; k < 3; ++k)
      c[i] += a[i / 3 * 3 + k] * b[3 * k + i % 3];
  return c;
}

/// C of the strain E moved by h in component k (engineering shears).
Voigt strained(Voigt C, int k, double h)
{
  C[k] += k < 3 ? 2 * h : h;
  return C;
}

double largest(const auto &values)
{
  double size = 0;
  for (const double v : values)
    size = std::max(size, std::abs(v));
  return size;
}

using Evaluation = std::function<MaterialLaw::Point(const Voigt &)>;

void check_derivatives(const Evaluation &evaluate, const Voigt &C)
{
  const auto p = evaluate(C);
  const double h = 1e-5, modulus = largest(p.tangent);
  for (int k = 0; k < 6; ++k) {
    const auto plus = evaluate(strained(C, k, h)), minus = evaluate(strained(C, k, -h));
    INFO("component " << k << ": stress " << p.stress[k] << ", difference " << (plus.energy - minus.energy) / (2 * h));
    CHECK(std::abs(p.stress[k] - (plus.energy - minus.energy) / (2 * h)) < 1e-7 * modulus);
    for (int i = 0; i < 6; ++i)
      CHECK(std::abs(p.tangent[6 * i + k] - (plus.stress[i] - minus.stress[i]) / (2 * h)) < 1e-6 * modulus);
  }
}

} // namespace

TEST_CASE("stress and tangent of every law are derivatives of its energy")
{
  for (const auto &parameters : all_materials) {
    const auto law = make_material(parameters);
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Voigt C = right_cauchy_green(random_deformation(seed));
      check_derivatives([&](const Voigt &c) { return law->evaluate(c); }, C);
      if (parameters.law == Law::neo_hookean)
        check_derivatives([&](const Voigt &c) { return law->evaluate_isochoric(c); }, C);
    }
  }
}

TEST_CASE("energy does not see a rotation of the deformed body")
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Matrix3 Q = times({c, -s, 0, s, c, 0, 0, 0, 1}, {1, 0, 0, 0, s, -c, 0, c, s});
  REQUIRE(determinant(Q) == Approx(1));
  for (const auto &parameters : all_materials) {
    const auto law = make_material(parameters);
    const Matrix3 F = random_deformation(3);
    CHECK(law->evaluate(right_cauchy_green(times(Q, F))).energy ==
          Approx(law->evaluate(right_cauchy_green(F)).energy).epsilon(1e-12));
  }
}

TEST_CASE("at rest: no energy, no stress, and the moduli asked for")
{
  for (const auto &parameters : all_materials) {
    const auto law = make_material(parameters);
    const auto p = law->evaluate(voigt_unit);
    CHECK(std::abs(p.energy) < 1e-14);
    CHECK(largest(p.stress) < 1e-12);
    for (int shear = 3; shear < 6; ++shear)
      CHECK(p.tangent[7 * shear] == Approx(law->shear_modulus()).epsilon(1e-12));
    CHECK((p.tangent[0] + p.tangent[1] + p.tangent[2]) / 3 == Approx(law->bulk_modulus()).epsilon(1e-12));
  }
  const auto rubber = make_material(neo_hookean()), plastic = make_material(by_moduli(Law::saint_venant));
  CHECK(rubber->shear_modulus() == Approx(0.32));
  CHECK(rubber->bulk_modulus() == Approx(100));
  CHECK(plastic->shear_modulus() == Approx(180 / 2.8));
  CHECK(plastic->bulk_modulus() == Approx(180 / 0.6));
}

TEST_CASE("the isochoric part is blind to volume, and the rest is kappa (J - 1)^2 / 2")
{
  const auto law = make_material(neo_hookean());
  const Voigt C = right_cauchy_green(random_deformation(1));
  Voigt swollen = C;
  for (double &c : swollen)
    c *= 1.69;
  const auto p = law->evaluate_isochoric(C);
  CHECK(law->evaluate_isochoric(swollen).energy == Approx(p.energy).epsilon(1e-12));
  CHECK(std::abs(dot(p.stress, {C[0], C[1], C[2], 2 * C[3], 2 * C[4], 2 * C[5]})) < 1e-14);
  const double J = std::sqrt(determinant(C));
  CHECK(law->evaluate(C).energy - p.energy == Approx(law->bulk_modulus() * (J - 1) * (J - 1) / 2));
  CHECK_THROWS_AS(make_material(by_moduli(Law::saint_venant))->evaluate_isochoric(C), std::logic_error);
}

TEST_CASE("von Mises stress of known states")
{
  const Matrix3 unit = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  CHECK(von_mises(unit, {3, 0, 0, 0, 0, 0}) == Approx(3));
  CHECK(von_mises(unit, {0, 0, 0, 0, 2, 0}) == Approx(2 * std::sqrt(3.)));
  CHECK(von_mises(unit, {5, 5, 5, 0, 0, 0}) == Approx(0).margin(1e-12));
  CHECK(von_mises(unit, {4, 1, 0, 0, 0, 0}) == Approx(std::sqrt(13.)));
  CHECK(von_mises({2, 0, 0, 0, 1, 0, 0, 0, 1}, {3, 0, 0, 0, 0, 0}) == Approx(6)); // sigma = F S F^T / J = 4 * 3 / 2
}

TEST_CASE("a missing coefficient is named")
{
  Material incomplete = neo_hookean();
  incomplete.d1.reset();
  CHECK_THROWS_WITH(make_material(incomplete), Catch::Contains("rubber") && Catch::Contains("d1"));
  incomplete = by_moduli(Law::saint_venant);
  incomplete.poisson_ratio.reset();
  CHECK_THROWS_WITH(make_material(incomplete), Catch::Contains("poisson_ratio"));
}
