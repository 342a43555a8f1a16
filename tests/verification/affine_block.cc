// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/affine_block.h"
#include <algorithm>
#include <cmath>

namespace ballonet::tests
{

using namespace solver;

namespace
{

Vector3 moved_by(const Matrix3 &F, const Point3 &X)
{
  Vector3 u;
  for (int i = 0; i < 3; ++i)
    u[i] = F[3 * i] * X[0] + F[3 * i + 1] * X[1] + F[3 * i + 2] * X[2] - X[i];
  return u;
}

bool on_boundary(const Point3 &X)
{
  return std::any_of(X.begin(), X.end(), [](double x) { return std::abs(x) < 1e-12 || std::abs(x - 1) < 1e-12; });
}

} // namespace

AffineBlock::AffineBlock(const Material &material, bool mixed)
    : mesh_(box_mesh(2, 2, 2, [](Point3 x) { return distorted(x, 0.08); })), discretization_(mesh_, MPI_COMM_SELF),
      work_(discretization_, 0, make_material(material), 0, mixed), system_(discretization_),
      newton_(system_, {&work_}, {}, nullptr, MPI_COMM_SELF, {.tolerance = 1e-12, .force_floor = 1e-3})
{
}

NewtonSolver::Outcome AffineBlock::deform(const Matrix3 &F)
{
  Prescribed boundary(3 * mesh_.nodes.size(), std::nan(""));
  for (std::size_t n = 0; n < mesh_.nodes.size(); ++n)
    if (on_boundary(mesh_.nodes[n])) {
      const auto u = moved_by(F, mesh_.nodes[n]);
      std::copy_n(u.begin(), 3, &boundary[3 * n]);
    }
  system_.prescribe(boundary);
  state_ = {};
  state_.displacement.assign(boundary.size(), 0.);
  work_.begin_step(state_, {.dt = 1});
  return newton_.solve(state_, {});
}

double AffineBlock::displacement_error(const Matrix3 &F) const
{
  double largest = 0;
  for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
    const auto u = moved_by(F, mesh_.nodes[n]);
    for (int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(state_.displacement[3 * n + d] - u[d]));
  }
  return largest;
}

std::vector<double> AffineBlock::stresses() const
{
  std::vector<double> stress(mesh_.cells.size());
  work_.stresses(state_, stress);
  return stress;
}

Matrix3 AffineBlock::mean_stress() const
{
  const auto forces = newton_.forces(state_);
  Matrix3 P{};
  for (std::size_t n = 0; n < mesh_.nodes.size(); ++n)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        P[3 * i + j] += forces[3 * n + i] * mesh_.nodes[n][j];
  return P;
}

} // namespace ballonet::tests
