// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/turned_blocks.h"
#include <catch2/catch.hpp>
#include <cmath>

namespace ballonet::tests
{

using namespace solver;

namespace
{

Mesh blocks()
{
  const auto lower = [](Point3 p) { return Point3{4 * p[0], 3 * p[1], p[2]}; };
  const auto upper = [](Point3 p) { return Point3{0.7 + 1.6 * p[0], 0.6 + 1.7 * p[1], 1 + p[2]}; };
  return beside(box_mesh(2, 2, 1, lower, "lower", "lower."), box_mesh(1, 2, 1, upper, "upper", "upper."));
}

Material rubber()
{
  Material m;
  m.name = "rubber", m.c10 = 0.2, m.d1 = 0.01;
  return m;
}

ContactPair pair(double friction, int passes)
{
  ContactPair p = {"pair", {"upper.z0"}, {"lower.z1"}, friction, 0.3, 10, 0.02};
  p.elastic_slip = 1e-3;
  p.passes = passes;
  return p;
}

} // namespace

Matrix3 rotation(double angle)
{
  const double n[3] = {1 / std::sqrt(14), 2 / std::sqrt(14), 3 / std::sqrt(14)};
  const double c = std::cos(angle), s = std::sin(angle);
  const Matrix3 cross = {0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0};
  Matrix3 R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      R[3 * i + j] = (i == j ? c : 0) + s * cross[3 * i + j] + (1 - c) * n[i] * n[j];
  return R;
}

std::vector<double> rotated(const Matrix3 &R, const std::vector<double> &field)
{
  std::vector<double> result(field.size());
  for (std::size_t k = 0; k < field.size(); k += 3)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        result[k + i] += R[3 * i + j] * field[k + j];
  return result;
}

TurnedBlocks::TurnedBlocks(double friction, int passes)
    : mesh_(blocks()), discretization_(mesh_, MPI_COMM_SELF),
      lower_(discretization_, 0, make_material(rubber()), 0, true),
      upper_(discretization_, 1, make_material(rubber()), 0, true),
      contact_(mesh_, pair(friction, passes), [](std::uint32_t) { return true; }),
      load_(discretization_, {"lower.x0", {0, 0, 0}, 0.05}), system_(discretization_),
      newton_(system_, {&lower_, &upper_, &load_, &contact_}, {}, nullptr, MPI_COMM_SELF,
              {.tolerance = 1e-11, .force_floor = 1e-3})
{
  state_.displacement.assign(3 * mesh_.nodes.size(), 0.);
  state_.friction.assign(3 * contact_.number_points_from(0), 0.);
}

void TurnedBlocks::turn_rigidly(double angle)
{
  std::vector<double> position = state_.displacement;
  for (std::size_t i = 0; i < position.size(); ++i)
    position[i] += mesh_.nodes[i / 3][i % 3];
  state_.displacement = rotated(rotation(angle), position);
  for (std::size_t i = 0; i < position.size(); ++i)
    state_.displacement[i] -= mesh_.nodes[i / 3][i % 3];
  angle_ += angle;
}

void TurnedBlocks::hold(const std::string &surface, const Vector3 &way, Prescribed &values) const
{
  for (const auto node : surface_nodes(mesh_, surface)) {
    const auto &X = mesh_.nodes[node];
    const auto x = rotated(turned(), {X[0] + way[0], X[1] + way[1], X[2] + way[2]});
    for (int d = 0; d < 3; ++d)
      values[3 * node + d] = x[d] - X[d];
  }
}

void TurnedBlocks::step(double dt, const Vector3 &way, double load_factor, double angle)
{
  for (VirtualWork *work : std::initializer_list<VirtualWork *>{&lower_, &upper_, &load_, &contact_})
    work->begin_step(state_, {.dt = dt});
  state_.load_factor = load_factor;
  turn_rigidly(angle);
  Prescribed values(state_.displacement.size(), std::nan(""));
  hold("lower.z0", {0, 0, 0}, values);
  hold("upper.z1", way, values);
  system_.prescribe(values);
  const auto outcome = newton_.solve(state_, {});
  INFO(outcome.reason << ", last residual " << outcome.residuals.back());
  REQUIRE(outcome.converged);
  state_.friction.assign(state_.friction.size(), 0.);
  contact_.end_step(state_);
}

} // namespace ballonet::tests
