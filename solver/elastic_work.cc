// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/elastic_work.h"
#include "solver/dense.h"
#include <algorithm>

namespace ballonet::solver
{

ElasticWork::ElasticWork(const Discretization &discretization, std::uint32_t body, std::unique_ptr<MaterialLaw> law,
                         double relaxation_time, bool mixed)
    : discretization_(discretization), law_(std::move(law)), relaxation_time_(relaxation_time), mixed_(mixed)
{
  for (const auto c : discretization.owned_cells())
    if (discretization.mesh().cell_body[c] == body) {
      Cell &cell = cells_.emplace_back(c, discretization.quadrature(c));
      Vector3 centre{};
      double volume = 0;
      for (int q = 0; q < n_points; ++q) {
        volume += cell.quadrature.weight[q];
        for (int d = 0; d < 3; ++d)
          centre[d] += cell.quadrature.weight[q] * cell.quadrature.position[q][d];
      }
      const double scale = 1 / std::cbrt(volume);
      for (int q = 0; q < n_points; ++q) {
        const auto &X = cell.quadrature.position[q];
        cell.pressure_shape[q] = {1, scale * (X[0] - centre[0] / volume), scale * (X[1] - centre[1] / volume),
                                  scale * (X[2] - centre[2] / volume)};
      }
      if (mixed)
        invert_mass(cell);
    }
}

void ElasticWork::invert_mass(Cell &cell) const
{
  cell.inverse_mass = {};
  for (int q = 0; q < n_points; ++q)
    for (int i = 0; i < n_pressures; ++i)
      for (int j = 0; j < n_pressures; ++j)
        cell.inverse_mass[n_pressures * i + j] +=
            cell.quadrature.weight[q] / law_->bulk_modulus() * cell.pressure_shape[q][i] * cell.pressure_shape[q][j];
  invert_spd(n_pressures, cell.inverse_mass.data());
}

CellVector ElasticWork::local(const Cell &cell, std::span<const double> field) const
{
  return gather(discretization_.mesh().cells[cell.index], field);
}

MaterialLaw::Point ElasticWork::material(const Cell &cell, int q, const Voigt &C, bool viscous) const
{
  auto point = mixed_ ? law_->evaluate_isochoric(C) : law_->evaluate(C);
  if (mixed_) {
    const double pressure = pressure_at(cell, q, cell.pressure), J = std::sqrt(determinant(C));
    const Voigt A = inverse(C);
    point.energy += pressure * (J - 1) - pressure * pressure / (2 * law_->bulk_modulus());
    for (int i = 0; i < 6; ++i)
      point.stress[i] += pressure * J * A[i];
    add_dyad(point.tangent, pressure * J, A, A);
    add_symmetric_product(point.tangent, -2 * pressure * J, A);
  }
  if (viscous && viscosity_ > 0) {
    Voigt strain = green_strain(C);
    for (int i = 0; i < 6; ++i)
      strain[i] -= cell.start_strain[q][i];
    Voigt2 D{};
    add_symmetric_product(D, viscosity_, cell.start_inverse[q]);
    const Voigt S = multiply(D, strain);
    point.energy += dot(S, strain) / 2;
    for (int i = 0; i < 6; ++i)
      point.stress[i] += S[i];
    for (int i = 0; i < 36; ++i)
      point.tangent[i] += D[i];
  }
  return point;
}

double ElasticWork::pressure_at(const Cell &cell, int q, const Pressures &p)
{
  const auto &N = cell.pressure_shape[q];
  return N[0] * p[0] + N[1] * p[1] + N[2] * p[2] + N[3] * p[3];
}

Voigt ElasticWork::stress_of(double pressure, const Voigt &C)
{
  const double J = std::sqrt(determinant(C));
  Voigt S = inverse(C);
  for (double &value : S)
    value *= pressure * J;
  return S;
}

ElasticWork::Pressures ElasticWork::pressure_increment(const Cell &cell, const CellVector &u,
                                                       const CellVector *du) const
{
  Pressures rhs{}, increment{};
  for (int q = 0; q < n_points; ++q) {
    const auto &G = cell.quadrature.gradient[q];
    const Matrix3 F = deformation_gradient(G, u);
    double miss = determinant(F) - 1 - pressure_at(cell, q, cell.pressure) / law_->bulk_modulus();
    if (du)
      miss += dot(cofactor(F), gradient(G, *du));
    for (int i = 0; i < n_pressures; ++i)
      rhs[i] += cell.quadrature.weight[q] * cell.pressure_shape[q][i] * miss;
  }
  for (int i = 0; i < n_pressures; ++i)
    for (int j = 0; j < n_pressures; ++j)
      increment[i] += cell.inverse_mass[n_pressures * i + j] * rhs[j];
  return increment;
}

void ElasticWork::add_condensed_pressures(const Cell &cell, const CellVector &u, CellMatrix &K) const
{
  std::array<double, n_pressures * n_cell_values> L{}, ML{};
  for (int q = 0; q < n_points; ++q) {
    const auto &G = cell.quadrature.gradient[q];
    const Matrix3 c = cofactor(deformation_gradient(G, u));
    CellVector dJ;
    for (int a = 0; a < n_cell_nodes; ++a)
      for (int m = 0; m < 3; ++m)
        dJ[3 * a + m] = c[3 * m] * G[a][0] + c[3 * m + 1] * G[a][1] + c[3 * m + 2] * G[a][2];
    for (int i = 0; i < n_pressures; ++i)
      for (int j = 0; j < n_cell_values; ++j)
        L[i * n_cell_values + j] += cell.quadrature.weight[q] * cell.pressure_shape[q][i] * dJ[j];
  }
  add_transposed_product(n_pressures, n_cell_values, n_pressures, cell.inverse_mass.data(), L.data(), ML.data());
  add_transposed_product(n_cell_values, n_cell_values, n_pressures, L.data(), ML.data(), K.data());
}

void ElasticWork::begin_step(const State &start, const Step &step)
{
  viscosity_ = 2 * law_->shear_modulus() * relaxation_time_ / step.rate_time();
  for (auto &cell : cells_) {
    const auto u = local(cell, start.displacement);
    if (mixed_) {
      const auto increment = pressure_increment(cell, u);
      for (int i = 0; i < n_pressures; ++i)
        cell.pressure[i] += increment[i];
    }
    for (int q = 0; q < n_points; ++q) {
      const Voigt C = right_cauchy_green(deformation_gradient(cell.quadrature.gradient[q], u));
      cell.start_strain[q] = green_strain(C);
      cell.start_inverse[q] = inverse(C);
      cell.stress[q] = material(cell, q, C).stress;
    }
  }
}

double ElasticWork::energy(const State &state) const { return stored_energy(state) + dissipated(state) / 2; }

double ElasticWork::stored_energy(const State &state) const
{
  double sum = 0;
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement);
    for (int q = 0; q < n_points; ++q)
      sum += cell.quadrature.weight[q] *
             material(cell, q, right_cauchy_green(deformation_gradient(cell.quadrature.gradient[q], u)), false).energy;
  }
  return sum;
}

double ElasticWork::dissipated(const State &state) const
{
  double sum = 0;
  if (viscosity_ == 0)
    return 0;
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement);
    for (int q = 0; q < n_points; ++q) {
      Voigt strain = green_strain(right_cauchy_green(deformation_gradient(cell.quadrature.gradient[q], u)));
      for (int i = 0; i < 6; ++i)
        strain[i] -= cell.start_strain[q][i];
      Voigt2 D{};
      add_symmetric_product(D, viscosity_, cell.start_inverse[q]);
      sum += cell.quadrature.weight[q] * dot(multiply(D, strain), strain);
    }
  }
  return sum;
}

void ElasticWork::residual(const State &state, Assembly &out) const
{
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement);
    const Pressures condensed = mixed_ ? pressure_increment(cell, u) : Pressures{}; // R_u + L^T M^-1 R_p
    CellVector r{};
    for (int q = 0; q < n_points; ++q) {
      const auto &G = cell.quadrature.gradient[q];
      const Matrix3 F = deformation_gradient(G, u);
      const Voigt C = right_cauchy_green(F), Sp = stress_of(pressure_at(cell, q, condensed), C);
      Voigt S = material(cell, q, C).stress;
      for (int i = 0; i < 6; ++i)
        S[i] += Sp[i];
      Matrix3 P{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            P[3 * i + j] += cell.quadrature.weight[q] * F[3 * i + k] * S[voigt_index[k][j]];
      for (int a = 0; a < n_cell_nodes; ++a)
        for (int i = 0; i < 3; ++i)
          r[3 * a + i] += P[3 * i] * G[a][0] + P[3 * i + 1] * G[a][1] + P[3 * i + 2] * G[a][2];
    }
    out.add_residual(discretization_.mesh().cells[cell.index], r);
  }
}

void ElasticWork::tangent(const State &state, Assembly &out) const
{
  static thread_local CellStiffness stiffness;
  static thread_local CellMatrix K;
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement);
    for (int q = 0; q < n_points; ++q) {
      const auto &G = cell.quadrature.gradient[q];
      const Matrix3 F = deformation_gradient(G, u);
      const auto tangent = material(cell, q, right_cauchy_green(F)).tangent;
      stiffness.set_point(q, cell.quadrature.weight[q], G, first_elasticity_tensor(F, cell.stress[q], tangent));
    }
    stiffness.sum(K);
    if (mixed_)
      add_condensed_pressures(cell, u, K);
    out.add_tangent(discretization_.mesh().cells[cell.index], K);
  }
}

void ElasticWork::advance(const State &from, std::span<const double> increment, double fraction)
{
  for (auto &cell : cells_) {
    const auto u = local(cell, from.displacement), du = local(cell, increment);
    const Pressures dp = mixed_ ? pressure_increment(cell, u, &du) : Pressures{};
    for (int q = 0; q < n_points; ++q) {
      const auto &G = cell.quadrature.gradient[q];
      const Matrix3 F = deformation_gradient(G, u);
      const Voigt C = right_cauchy_green(F);
      const auto point = material(cell, q, C);
      const Voigt dS = multiply(point.tangent, strain_increment(F, gradient(G, du)));
      const Voigt Sp = stress_of(pressure_at(cell, q, dp), C);
      for (int i = 0; i < 6; ++i)
        cell.stress[q][i] += fraction * (point.stress[i] + dS[i] + Sp[i] - cell.stress[q][i]);
    }
    for (int i = 0; i < n_pressures; ++i)
      cell.pressure[i] += fraction * dp[i];
  }
}

double ElasticWork::largest_step(const State &state, std::span<const double> increment) const
{
  constexpr double least_ratio = 0.2; // det F may shrink to this share of itself in one iteration
  double fraction = 1;
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement), du = local(cell, increment);
    for (int q = 0; q < n_points; ++q) {
      const Matrix3 F = deformation_gradient(cell.quadrature.gradient[q], u);
      const Matrix3 H = gradient(cell.quadrature.gradient[q], du);
      const auto trial = [&](double s) {
        Matrix3 T = F;
        for (int i = 0; i < 9; ++i)
          T[i] += s * H[i];
        return determinant(T);
      };
      while (fraction > 1e-6 && trial(fraction) < least_ratio * determinant(F))
        fraction *= 0.7;
    }
  }
  return fraction;
}

void ElasticWork::stresses(const State &state, std::vector<double> &stress) const
{
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement);
    double largest = 0;
    for (int q = 0; q < n_points; ++q) {
      const Matrix3 F = deformation_gradient(cell.quadrature.gradient[q], u);
      largest = std::max(largest, von_mises(F, material(cell, q, right_cauchy_green(F), false).stress));
    }
    stress[cell.index] = largest;
  }
}

double ElasticWork::smallest_volume_ratio(const State &state) const
{
  double smallest = 1e300;
  for (const auto &cell : cells_) {
    const auto u = local(cell, state.displacement);
    for (int q = 0; q < n_points; ++q)
      smallest = std::min(smallest, determinant(deformation_gradient(cell.quadrature.gradient[q], u)));
  }
  return smallest;
}

} // namespace ballonet::solver
