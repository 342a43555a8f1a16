// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/load_work.h"
#include <cmath>
#include <stdexcept>

namespace ballonet::solver
{

void add_nodal_mass(const Discretization &discretization, std::uint32_t body, double density, std::vector<double> &mass)
{
  // int N_a dV with N_a from the one-dimensional quadratic shape functions at the Gauss points
  const double g = std::sqrt(0.15), points[3] = {0.5 - g, 0.5, 0.5 + g};
  const auto shape = [](int i, double x) {
    return i == 0 ? (1 - x) * (1 - 2 * x) : i == 1 ? 4 * x * (1 - x) : x * (2 * x - 1);
  };
  const auto &mesh = discretization.mesh();
  for (const auto c : discretization.owned_cells()) {
    if (mesh.cell_body[c] != body || density == 0)
      continue;
    const auto quadrature = discretization.quadrature(c);
    for (int q = 0; q < n_points; ++q)
      for (int a = 0; a < n_cell_nodes; ++a)
        mass[mesh.cells[c][a]] += density * quadrature.weight[q] * shape(a % 3, points[q % 3]) *
                                  shape(a / 3 % 3, points[q / 3 % 3]) * shape(a / 9, points[q / 9]);
  }
}

namespace
{

/// A surface carries traction and pressure, a set of nodes a force.
void check(const Load &load)
{
  const bool on_surface = load.traction != Vector3{} || load.pressure != 0, on_nodes = load.force != Vector3{};
  if (load.surface.empty() == load.nodes.empty() || (on_surface && load.surface.empty()) ||
      (on_nodes && load.nodes.empty()))
    throw std::invalid_argument("a load on surface \"" + load.surface + "\" and nodes \"" + load.nodes +
                                "\"; allowed are a surface with traction or pressure, or nodes with a force");
}

} // namespace

DeadLoad::DeadLoad(const Discretization &discretization, const std::vector<double> &mass, const Vector3 &gravity,
                   const std::vector<Load> &loads)
    : force_(3 * mass.size())
{
  for (std::size_t node = 0; node < mass.size(); ++node)
    for (int d = 0; d < 3; ++d)
      force_[3 * node + d] = mass[node] * gravity[d];
  for (const auto &load : loads) {
    check(load);
    if (load.nodes.empty())
      add_traction(discretization, load);
    else
      add_nodal_forces(discretization, load);
  }
  for (Node node = 0; node < mass.size(); ++node)
    if (force_[3 * node] != 0 || force_[3 * node + 1] != 0 || force_[3 * node + 2] != 0)
      nodes_.push_back(node);
}

void DeadLoad::add_traction(const Discretization &discretization, const Load &load)
{
  const auto &mesh = discretization.mesh();
  const auto &basis = face_basis();
  for (const auto &face : faces_of(mesh, load.surface)) {
    if (!discretization.owns(face.cell))
      continue;
    const auto nodes = face_nodes(mesh, face);
    for (int q = 0; q < n_face_nodes; ++q) {
      Vector3 xi{}, eta{};
      for (int a = 0; a < n_face_nodes; ++a)
        for (int d = 0; d < 3; ++d) {
          xi[d] += basis.derivative[q][a][0] * mesh.nodes[nodes[a]][d];
          eta[d] += basis.derivative[q][a][1] * mesh.nodes[nodes[a]][d];
        }
      const double area = std::hypot(xi[1] * eta[2] - xi[2] * eta[1], xi[2] * eta[0] - xi[0] * eta[2],
                                     xi[0] * eta[1] - xi[1] * eta[0]) *
                          basis.weight[q];
      for (int a = 0; a < n_face_nodes; ++a)
        for (int d = 0; d < 3; ++d)
          force_[3 * nodes[a] + d] += area * basis.value[q][a] * load.traction[d];
    }
  }
}

/// Every node by the rank that owns its equations.
void DeadLoad::add_nodal_forces(const Discretization &discretization, const Load &load)
{
  const auto &nodes = nodes_of_set(discretization.mesh(), load.nodes);
  const auto [first, end] = discretization.owned_blocks();
  for (const auto node : nodes)
    if (const int block = discretization.block(node); block >= first && block < end)
      for (int d = 0; d < 3; ++d)
        force_[3 * node + d] += load.force[d] / static_cast<double>(nodes.size());
}

double DeadLoad::energy(const State &state) const
{
  double work = 0;
  for (const auto node : nodes_)
    for (int d = 0; d < 3; ++d)
      work += force_[3 * node + d] * state.displacement[3 * node + d];
  return -state.load_factor * work;
}

void DeadLoad::residual(const State &state, Assembly &out) const
{
  for (const auto node : nodes_) {
    Vector3 r;
    for (int d = 0; d < 3; ++d)
      r[d] = -state.load_factor * force_[3 * node + d];
    out.add_residual({&node, 1}, r);
  }
}

FollowerLoad::FollowerLoad(const Discretization &discretization, const Load &load)
    : discretization_(discretization), swept_(discretization, Cavity{load.surface, {0, 0, 0}, {"x", "y", "z"}}),
      pressure_(load.pressure)
{
  for (const auto &face : faces_of(discretization.mesh(), load.surface))
    if (discretization.owns(face.cell))
      faces_.push_back(face_nodes(discretization.mesh(), face));
}

double FollowerLoad::energy(const State &state) const { return -state.load_factor * pressure_ * swept_.volume(state); }

FaceTangents FollowerLoad::tangents(const std::array<Node, n_face_nodes> &nodes, const State &state, int q) const
{
  const auto &basis = face_basis();
  FaceTangents t;
  for (int a = 0; a < n_face_nodes; ++a)
    for (int d = 0; d < 3; ++d) {
      const double x = discretization_.mesh().nodes[nodes[a]][d] + state.displacement[3 * nodes[a] + d];
      t.xi[d] += basis.derivative[q][a][0] * x;
      t.eta[d] += basis.derivative[q][a][1] * x;
    }
  return t;
}

void FollowerLoad::residual(const State &state, Assembly &out) const
{
  const auto &basis = face_basis();
  for (const auto &face : faces_) {
    std::array<double, 3 * n_face_nodes> r{};
    for (int q = 0; q < n_face_nodes; ++q) {
      const auto t = tangents(face, state, q);
      for (int d = 0; d < 3; ++d) {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        const double force =
            state.load_factor * pressure_ * basis.weight[q] * (t.xi[e] * t.eta[f] - t.xi[f] * t.eta[e]);
        for (int k = 0; k < n_face_nodes; ++k)
          r[3 * k + d] += basis.value[q][k] * force;
      }
    }
    out.add_residual(face, r);
  }
}

void FollowerLoad::tangent(const State &state, Assembly &out) const
{
  const auto &basis = face_basis();
  constexpr int n = 3 * n_face_nodes;
  for (const auto &face : faces_) {
    std::array<double, n * n> K{};
    for (int q = 0; q < n_face_nodes; ++q) {
      const auto t = tangents(face, state, q);
      const double w = state.load_factor * pressure_ * basis.weight[q] / 2;
      for (int k = 0; k < n_face_nodes; ++k)
        for (int l = 0; l < n_face_nodes; ++l)
          for (int d = 0; d < 3; ++d)
            for (int s = 1; s < 3; ++s) {
              const int e = (d + s) % 3, f = (d + 3 - s) % 3;
              const auto &dl = basis.derivative[q][l];
              const double value =
                  (s == 1 ? w : -w) * basis.value[q][k] * (dl[0] * t.eta[f] - dl[1] * t.xi[f]); // d r_kd / d u_le
              K[(3 * k + d) * n + 3 * l + e] += value;
              K[(3 * l + e) * n + 3 * k + d] += value;
            }
    }
    out.add_tangent(face, K);
  }
}

} // namespace ballonet::solver
