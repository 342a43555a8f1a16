// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/cavity_work.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::solver
{

namespace
{

Vector3 cross(const Vector3 &a, const Vector3 &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace

/// x (relative to the origin, weighted by direction) and the two tangents at a Gauss point.
struct CavityWork::Point {
  Vector3 x{}, xi{}, eta{};
  Point(const FaceVector &nodes, int q, const Vector3 &share)
  {
    const auto &basis = face_basis();
    for (int a = 0; a < n_face_nodes; ++a)
      for (int d = 0; d < 3; ++d) {
        x[d] += share[d] * basis.value[q][a] * nodes[3 * a + d];
        xi[d] += basis.derivative[q][a][0] * nodes[3 * a + d];
        eta[d] += basis.derivative[q][a][1] * nodes[3 * a + d];
      }
  }
};

CavityWork::CavityWork(const Discretization &discretization, const Cavity &cavity)
    : discretization_(discretization), origin_(cavity.origin), share_{0, 0, 0}
{
  if (cavity.directions.empty())
    throw std::invalid_argument("cavity: directions is empty; at least one of x, y, z is needed");
  for (const auto &direction : cavity.directions)
    share_[direction[0] - 'x'] = 1. / cavity.directions.size();
  for (const auto &face : faces_of(discretization.mesh(), cavity.surface))
    if (discretization.owns(face.cell))
      faces_.push_back(face_nodes(discretization.mesh(), face));
}

CavityWork::FaceVector CavityWork::positions(const std::array<Node, n_face_nodes> &nodes, const State &state) const
{
  FaceVector x;
  for (int a = 0; a < n_face_nodes; ++a)
    for (int d = 0; d < 3; ++d)
      x[3 * a + d] = discretization_.mesh().nodes[nodes[a]][d] + state.displacement[3 * nodes[a] + d] - origin_[d];
  return x;
}

double CavityWork::volume(const State &state) const
{
  double volume = 0;
  for (const auto &face : faces_) {
    const auto nodes = positions(face, state);
    for (int q = 0; q < n_face_nodes; ++q) {
      const Point p(nodes, q, share_);
      const Vector3 n = cross(p.xi, p.eta);
      volume -= face_basis().weight[q] * (p.x[0] * n[0] + p.x[1] * n[1] + p.x[2] * n[2]);
    }
  }
  return volume;
}

void CavityWork::add_gradient(const State &state, double factor, Assembly &out) const
{
  const auto &basis = face_basis();
  for (const auto &face : faces_) {
    const auto nodes = positions(face, state);
    FaceVector g{};
    for (int q = 0; q < n_face_nodes; ++q) {
      const Point p(nodes, q, share_);
      // V = -det(x, xi, eta): derivatives with respect to its three columns
      const Vector3 n = cross(p.xi, p.eta), a = cross(p.eta, p.x), b = cross(p.x, p.xi);
      for (int k = 0; k < n_face_nodes; ++k)
        for (int d = 0; d < 3; ++d)
          g[3 * k + d] -= factor * basis.weight[q] *
                          (share_[d] * basis.value[q][k] * n[d] + basis.derivative[q][k][0] * a[d] +
                           basis.derivative[q][k][1] * b[d]);
    }
    out.add_residual(face, g);
  }
}

void CavityWork::volume_gradient(const State &state, Assembly &out) const { add_gradient(state, 1, out); }

void CavityWork::residual(const State &state, Assembly &out) const { add_gradient(state, -state.pressure, out); }

void CavityWork::tangent(const State &state, Assembly &out) const
{
  const auto &basis = face_basis();
  constexpr int n = 3 * n_face_nodes;
  for (const auto &face : faces_) {
    const auto nodes = positions(face, state);
    std::array<double, n * n> K{};
    for (int q = 0; q < n_face_nodes; ++q) {
      const Point p(nodes, q, share_);
      const double w = state.pressure * basis.weight[q];
      for (int k = 0; k < n_face_nodes; ++k)
        for (int l = 0; l < n_face_nodes; ++l) {
          const double N[2] = {basis.value[q][k], basis.value[q][l]};
          const auto &dk = basis.derivative[q][k], &dl = basis.derivative[q][l];
          for (int d = 0; d < 3; ++d)
            for (int s = 1; s < 3; ++s) {
              const int e = (d + s) % 3, f = (d + 3 - s) % 3;
              const double sign = s == 1 ? 1 : -1; // epsilon_def
              // det(x, xi, eta) = eps_def x_d xi_e eta_f: all pairs of columns
              const double sum = share_[d] * N[0] * (dl[0] * p.eta[f] - dl[1] * p.xi[f]) +
                                 dk[0] * (dl[1] * p.x[f] - share_[e] * N[1] * p.eta[f]) +
                                 dk[1] * (share_[e] * N[1] * p.xi[f] - dl[0] * p.x[f]);
              K[(3 * k + d) * n + 3 * l + e] += w * sign * sum;
            }
        }
    }
    out.add_tangent(face, K);
  }
}

} // namespace ballonet::solver
