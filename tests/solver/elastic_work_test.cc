// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/elastic_work.h"
#include "tests/support/box_mesh.h"
#include "tests/support/derivative_check.h"

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

struct Variant {
  const char *name;
  Law law;
  bool mixed;
  double relaxation_time;
};

const std::vector<Variant> variants = {{"neo-Hookean", Law::neo_hookean, false, 0},
                                       {"Saint-Venant", Law::saint_venant, false, 0},
                                       {"neo-Hookean, mixed", Law::neo_hookean, true, 0},
                                       {"Saint-Venant, viscous", Law::saint_venant, false, 0.005},
                                       {"neo-Hookean, mixed, viscous", Law::neo_hookean, true, 0.005}};

/// Two distorted cells of one material, in some deformed state.
struct Specimen {
  Mesh mesh = box_mesh(2, 1, 1, [](Point3 x) {
    return Point3{2 * x[0] + 0.1 * x[1] * x[2], x[1] - 0.2 * x[0] * x[0], 0.7 * x[2] + 0.1 * x[0]};
  });
  Discretization discretization{mesh, MPI_COMM_SELF};
  ElasticWork work;
  State start, state;

  explicit Specimen(const Variant &variant)
      : work(discretization, 0, make_material(material(variant.law)), variant.relaxation_time, variant.mixed)
  {
    start.displacement = random_field(3 * mesh.nodes.size(), 0.02, 5);
    state = moved(start, random_field(3 * mesh.nodes.size(), 0.03, 6), 1);
    work.begin_step(start, {.dt = 0.01});
    make_consistent(state);
  }
  static Material material(Law law)
  {
    Material m;
    m.law = law, m.youngs_modulus = 2, m.poisson_ratio = 0.45;
    return m;
  }
  /// Gives the stored stresses and pressures the values that belong to a state.
  void make_consistent(const State &at)
  {
    const std::vector<double> nothing(at.displacement.size());
    work.advance(at, nothing, 1);
  }
  State rotated(State at) const
  {
    const double c = std::cos(1.1), s = std::sin(1.1);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const auto &X = mesh.nodes[n];
      double *u = &at.displacement[3 * n];
      const double x = X[0] + u[0], y = X[1] + u[1];
      u[0] = c * x - s * y - X[0], u[1] = s * x + c * y - X[1];
    }
    return at;
  }
};

} // namespace

TEST_CASE("elastic work: residual and tangent are derivatives of the energy")
{
  for (const auto &variant : variants) {
    INFO(variant.name);
    Specimen specimen(variant);
    // The mixed energy holds the element pressures; at their own equilibrium its slope is the condensed one.
    check_residual(specimen.work, specimen.state);
    check_tangent(specimen.work, specimen.state, [&](const State &at) { return residual(specimen.work, at); });
  }
}

TEST_CASE("elastic work: stored pressures do not change the mixed residual")
{
  Specimen specimen(variants[2]);
  const auto consistent = residual(specimen.work, specimen.state);
  specimen.make_consistent(specimen.start);
  const auto stale = residual(specimen.work, specimen.state);
  for (std::size_t i = 0; i < stale.size(); ++i)
    CHECK(std::abs(stale[i] - consistent[i]) < 1e-12 * norm(consistent));
}

TEST_CASE("elastic work: a rotation leaves the energy and turns the residual")
{
  for (const auto &variant : variants) {
    INFO(variant.name);
    Specimen specimen(variant);
    const State turned = specimen.rotated(specimen.state);
    CHECK(specimen.work.energy(turned) == Approx(specimen.work.energy(specimen.state)).epsilon(1e-11));
    const auto before = residual(specimen.work, specimen.state), after = residual(specimen.work, turned);
    const double c = std::cos(1.1), s = std::sin(1.1), small = 1e-11 * norm(before);
    for (std::size_t n = 0; n < before.size(); n += 3) {
      CHECK(std::abs(after[n] - (c * before[n] - s * before[n + 1])) < small);
      CHECK(std::abs(after[n + 1] - (s * before[n] + c * before[n + 1])) < small);
      CHECK(std::abs(after[n + 2] - before[n + 2]) < small);
    }
  }
}

TEST_CASE("elastic work: viscosity takes energy, none in a rigid motion")
{
  Specimen specimen(variants[3]);
  CHECK(specimen.work.dissipated(specimen.state) > 0);
  CHECK(specimen.work.dissipated(specimen.rotated(specimen.start)) < 1e-20);
  CHECK(specimen.work.energy(specimen.state) ==
        Approx(specimen.work.stored_energy(specimen.state) + specimen.work.dissipated(specimen.state) / 2));
}

TEST_CASE("elastic work: an increment that would turn a cell inside out is shortened")
{
  Specimen specimen(variants[0]);
  std::vector<double> collapse(specimen.start.displacement.size());
  for (std::size_t n = 0; n < specimen.mesh.nodes.size(); ++n)
    collapse[3 * n] = -1.5 * specimen.mesh.nodes[n][0];
  const double fraction = specimen.work.largest_step(specimen.start, collapse);
  INFO("fraction " << fraction);
  CHECK(fraction < 2. / 3);
  CHECK(fraction > 0.1);
  CHECK(specimen.work.smallest_volume_ratio(moved(specimen.start, collapse, fraction)) > 0);
}
