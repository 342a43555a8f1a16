// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include "tests/support/nodal_fields.h"
#include "tests/verification/turned_blocks.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double right_angle = M_PI / 2;

/// Presses the upper block down by 0.15 mm, then slides it by 0.7 mm in `steps` steps while all is turned by `angle`.
void slide(TurnedBlocks &blocks, int steps, double angle)
{
  for (int i = 1; i <= 2; ++i)
    blocks.step(0.1, {0, 0, -0.075 * i}, i / 2., 0);
  for (int i = 1; i <= steps; ++i)
    blocks.step(1. / steps, {0.6 * i / steps, 0.3 * i / steps, -0.15}, 1, angle / steps);
}

/// What turning changed, relative to the blocks that were not turned.
struct Change {
  double forces, contact_force, energy;
};

double relative_change(const std::vector<double> &expected, std::vector<double> field)
{
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] -= expected[i];
  return norm(field) / norm(expected);
}

Change change_by_turning(double friction, int passes, int steps)
{
  TurnedBlocks still(friction, passes), moving(friction, passes);
  slide(still, steps, 0);
  slide(moving, steps, right_angle);
  const auto turned = [&](const auto &field) { return rotated(moving.turned(), {field.begin(), field.end()}); };
  const auto contact = moving.contact().secondary_force;
  return {relative_change(turned(still.forces()), moving.forces()),
          relative_change(turned(still.contact().secondary_force), {contact.begin(), contact.end()}),
          moving.stored_energy() / still.stored_energy() - 1};
}

} // namespace

// Two blocks under follower pressure and in sliding contact, turned by 90 degrees while they slide: forces must turn
// along, energies stay.
TEST_CASE("objectivity: turning an assembly without friction changes nothing")
{
  const auto change = change_by_turning(0, 2, 5);
  const char *law = "objectivity";
  const auto kind = Comparison::Kind::absolute;
  compare({"turned by 90 degrees, no friction: change of all forces", law, 0, change.forces, 1e-9, "1", kind});
  compare({"turned by 90 degrees, no friction: change of the contact force", law, 0, change.contact_force, 1e-9, "1",
           kind});
  compare({"turned by 90 degrees, no friction: change of the stored energy", law, 0, change.energy, 1e-10, "1", kind});
}

// Friction acts in the plane of contact at the start of the step, so it lags behind by the rotation within one step: an
// error of first order that halves with the step.
TEST_CASE("objectivity: friction lags by the rotation within a step")
{
  const auto large = change_by_turning(0.3, 1, 5), small = change_by_turning(0.3, 1, 10);
  const char *law = "objectivity; first order in the rotation of a step";
  const auto kind = Comparison::Kind::absolute;
  compare({"turned by 90 degrees in steps of 18, friction 0.3: change of all forces", law, 0, large.forces, 2e-2, "1",
           kind});
  compare({"turned by 90 degrees in steps of 9, friction 0.3: change of all forces", law, 0, small.forces, 1e-2, "1",
           kind});
  compare({"turned by 90 degrees in steps of 9, friction 0.3: change of the contact force", law, 0, small.contact_force,
           1e-2, "1", kind});
  compare({"turned by 90 degrees in steps of 9, friction 0.3: change of the stored energy", law, 0, small.energy, 1e-2,
           "1", kind});
  compare({"turned by 90 degrees, friction 0.3: observed order of the change of forces", "theory: 1", 0.8,
           std::log2(large.forces / small.forces), 0, "1", Comparison::Kind::at_least});
}
