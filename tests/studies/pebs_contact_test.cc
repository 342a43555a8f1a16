// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "solver/contact_work.h"
#include "solver/self_penetration.h"
#include "solver/simulation.h"
#include "studies/obstacle_gauge.h"
#include "studies/response_names.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

using namespace ballonet;
using namespace ballonet::studies;
using ballonet::tests::Folder;

namespace
{

/// A coarse backbone of four ribs without a balloon, straight when it is at rest.
Study short_backbone()
{
  Study study = default_study(ActuatorKind::pebs);
  study.actuator.pebs.with_balloon = false;
  study.actuator.pebs.ribs.count = 4;
  study.mesh.along_fold = 6, study.mesh.across_wall = 2, study.mesh.around_ring = 16;
  study.contact.self = {"backbone"};
  study.path.control = solver::Control::load;
  study.path.load_steps = 4;
  return study;
}

SimulationModel built(const Study &study)
{
  auto model = build_model(study);
  REQUIRE(std::holds_alternative<SimulationModel>(model));
  return std::get<SimulationModel>(std::move(model));
}

double largest(const SimulationModel &model, const solver::State &state, int direction)
{
  double most = -1e9;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n)
    most = std::max(most, model.mesh.nodes[n][direction] + state.displacement[3 * n + direction]);
  return most;
}

/// How many points of the head and the base look at each other and touch when the head's nodes are moved.
std::size_t touching_head_and_base(const SimulationModel &model, const solver::Vector3 &head_moved_by)
{
  const solver::Mesh mesh = solver_mesh(model.mesh);
  solver::ContactWork work(mesh, model.parameters.contact_pairs.at(0), [](std::uint32_t) { return true; });
  solver::State state;
  state.displacement.resize(3 * mesh.nodes.size());
  const auto &head = model.layout->head;
  for (const auto node : head)
    for (int d = 0; d < 3; ++d)
      state.displacement[3 * node + d] = head_moved_by[d];
  const auto of_head = [&](std::uint32_t cell) {
    return std::binary_search(head.begin(), head.end(), mesh.cells[cell][13]);
  };
  const auto of_base = [&](std::uint32_t cell) { return mesh.nodes[mesh.cells[cell][13]][2] < 0; };
  work.begin_step(state, {.dt = 1e-3});
  const auto points = work.contact_points(state);
  return std::count_if(points.begin(), points.end(), [&](const solver::ContactPoint &p) {
    const auto a = p.secondary.cell, b = p.primary->cell;
    return (of_head(a) && of_base(b)) || (of_head(b) && of_base(a));
  });
}

} // namespace

TEST_CASE("a backbone's contact with itself finds its head on its base: flat, and rim against rim")
{
  const SimulationModel model = built(short_backbone());
  REQUIRE(model.parameters.contact_pairs.size() == 1);
  CHECK(touching_head_and_base(model, {0, 0, 0}) == 0);
  const double height = model.layout->height, radius = 9.5;
  CHECK(touching_head_and_base(model, {0, 0, -height - 0.1}) > 100);
  CHECK(touching_head_and_base(model, {2 * radius - 0.3, 0, -height - 2}) > 0);
  CHECK(touching_head_and_base(model, {2 * radius + 0.1, 0, -height - 2}) == 0);
}

TEST_CASE("a backbone pulled over sideways comes to rest with its ribs on each other")
{
  Study study = short_backbone();
  study.gravity = {1e6, 0, 0};
  const SimulationModel model = built(study);
  const solver::Mesh mesh = solver_mesh(model.mesh);
  solver::Simulation simulation(model.parameters, mesh, MPI_COMM_SELF);
  const auto result = simulation.run([](const solver::PathPoint &) { return ""; }, [](const std::string &) {});
  INFO(result.reason);
  REQUIRE(result.status == solver::PathStatus::ended);
  const solver::State &state = simulation.progress().state;
  const auto contact = simulation.equilibrium().contacts().summaries(state).at(0);
  CHECK(contact.normal_force > 0.1);
  CHECK(contact.penetration < study.contact.penetration_limit);
  CHECK(solver::SelfPenetration(mesh, model.parameters.contact_pairs[0], study.contact.penetration_limit)
            .find(state)
            .empty());
}

TEST_CASE("only the parts that are named touch themselves, and only what is there")
{
  Study study = short_backbone();
  study.contact.self = {"balloon"};
  CHECK(built(study).parameters.contact_pairs.empty());
  study.actuator.pebs.with_balloon = true;
  study.actuator.pebs.balloon.length = 18;
  study.contact.self = {"balloon", "backbone"};
  std::vector<std::string> names;
  for (const auto &pair : built(study).parameters.contact_pairs)
    names.push_back(pair.name);
  CHECK(names == std::vector<std::string>{"cage", "balloon", "backbone"});
}

TEST_CASE("a backbone that falls sideways onto a rigid wall is held by it")
{
  Study study = short_backbone();
  study.contact.friction = 0;
  study.gravity = {1.5e5, 0, 0};
  solver::RigidBody wall;
  wall.name = "wall", wall.point = {9.8, 0, 0}, wall.axis = {-1, 0, 0};
  const auto fallen = [&](bool with_wall) {
    study.rigid_bodies.clear();
    if (with_wall)
      study.rigid_bodies = {wall};
    return built(study);
  };
  const auto reach = [](const SimulationModel &model) {
    const solver::Mesh mesh = solver_mesh(model.mesh);
    solver::Simulation simulation(model.parameters, mesh, MPI_COMM_SELF);
    double end = 0;
    Row row;
    const auto result = simulation.run(
        [&](const solver::PathPoint &point) {
          row.clear();
          ObstacleGauge(model.parameters, true).measure(point, simulation.equilibrium(), row);
          end = largest(model, point.progress.state, 0);
          return "";
        },
        [](const std::string &) {});
    INFO(result.reason);
    REQUIRE(result.status == solver::PathStatus::ended);
    const auto &state = simulation.progress().state;
    const auto reactions = simulation.equilibrium().reactions(state);
    double held = 0;
    for (const auto node : surface_nodes(model.mesh, "base_bottom"))
      held += reactions[3 * node];
    return std::tuple{end, row, held};
  };
  const auto [free_end, no_columns, free_base] = reach(fallen(false));
  const auto [end, columns, base] = reach(fallen(true));
  CHECK(free_end > 10.2);
  CHECK(end > 9.8);
  CHECK(end < 9.8 + study.contact.penetration_limit);
  CHECK(no_columns.empty());
  REQUIRE(columns.size() == 1);
  CHECK(columns[0].first == "wall_force_N");
  CHECK(columns[0].second > 0.01);
  // the weight, all of it on the base without the wall; reactions are those of the half model
  CHECK(2 * std::abs(base) + columns[0].second == Approx(2 * std::abs(free_base)).epsilon(1e-5));
  const auto names = history_columns(study);
  CHECK(std::find(names.begin(), names.end(), "wall_force_N") != names.end());
}

TEST_CASE("a rigid body of a pebs needs a name of its own")
{
  const Folder folder("rigid_names");
  const auto [name, message] =
      GENERATE(std::tuple{"", "a name of its own"}, std::tuple{"cage", "which names a part of the actuator"},
               std::tuple{"balloon_outer", "which names a part of the actuator"});
  tests::StudyRun run(folder, std::string("[actuator]\nkind = \"pebs\"\n[[rigid]]\nname = \"") + name + "\"\n");
  CHECK(run({"--dry-run"}) == 2);
  INFO(run.text);
  CHECK(run.text.find(message) != std::string::npos);
}

TEST_CASE("the reduced model knows no rigid bodies")
{
  const Folder folder("rigid_reduced");
  tests::StudyRun run(folder, "[actuator]\nkind = \"pebs\"\n[method]\nmodel = \"reduced\"\n[contact]\nfriction = "
                              "0\n[[rigid]]\nname = \"wall\"\n");
  CHECK(run({"--dry-run"}) == 2);
  INFO(run.text);
  CHECK(run.text.find("rigid") != std::string::npos);
}

TEST_CASE("pebs contact: all pairs are enforced as the block says, by the penalty if it says nothing")
{
  Study study = short_backbone();
  study.actuator.pebs.with_balloon = true;
  study.actuator.pebs.balloon.length = 18;
  study.contact.self = {"backbone", "balloon"};
  for (const auto &pair : built(study).parameters.contact_pairs)
    CHECK(pair.enforcement == solver::Enforcement::penalty);
  study.contact.enforcement = solver::Enforcement::augmented_lagrangian;
  study.contact.augmentation_tolerance = 0.02;
  study.contact.max_augmentations = 3;
  const SimulationModel model = built(study);
  CHECK(model.parameters.contact_pairs.size() == 3);
  for (const auto &pair : model.parameters.contact_pairs) {
    CHECK(pair.enforcement == solver::Enforcement::augmented_lagrangian);
    CHECK(pair.augmentation_tolerance == 0.02);
    CHECK(pair.max_augmentations == 3);
  }
}
