// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/elastic_work.h"
#include "solver/cell_stiffness.h"
#include "solver/dense.h"
#include <algorithm>

namespace ballonet::solver
{

/// R_p = int N (J - 1 - p / kappa), M = int N N^T / kappa, L = d R_p / d u of one cell.
struct ElasticWork::PressureSystem {
  std::array<double, n_pressures> residual{};
  std::array<double, n_pressures * n_pressures> mass{};
  std::array<double, n_pressures * n_cell_values> coupling{};

  /// M^-1 (R_p + L du): the pressure increment that belongs to du.
  std::array<double, n_pressures> increment(const CellVector *du) const
  {
    auto rhs = residual;
    if (du)
      for (int i = 0; i < n_pressures; ++i)
        for (int j = 0; j < n_cell_values; ++j)
          rhs[i] += coupling[i * n_cell_values + j] * (*du)[j];
    auto inverse = mass;
    invert_spd(n_pressures, inverse.data());
    std::array<double, n_pressures> p{};
    for (int i = 0; i < n_pressures; ++i)
      for (int j = 0; j < n_pressures; ++j)
        p[i] += inverse[i * n_pressures + j] * rhs[j];
    return p;
  }
};

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
    }
}

CellVector ElasticWork::local(const Cell &cell, std::span<const double> field) const
{
  return gather(discretization_.mesh().cells[cell.index], field);
}

MaterialLaw::Point ElasticWork::material(const Cell &cell, int q, const Voigt &C, bool viscous) const
{
  auto point = mixed_ ? law_->evaluate_isochoric(C) : law_->evaluate(C);
  if (mixed_) {
    double pressure = 0;
    for (int i = 0; i < n_pressures; ++i)
      pressure += cell.pressure_shape[q][i] * cell.pressure[i];
    const double J = std::sqrt(determinant(C));
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

ElasticWork::PressureSystem ElasticWork::pressure_system(const Cell &cell, const CellVector &u) const
{
  PressureSystem system;
  for (int q = 0; q < n_points; ++q) {
    const auto &G = cell.quadrature.gradient[q];
    const Matrix3 F = deformation_gradient(G, u);
    const double w = cell.quadrature.weight[q], J = determinant(F);
    const auto &N = cell.pressure_shape[q];
    double pressure = 0;
    for (int i = 0; i < n_pressures; ++i)
      pressure += N[i] * cell.pressure[i];
    const Matrix3 cofactor = {F[4] * F[8] - F[5] * F[7], F[5] * F[6] - F[3] * F[8], F[3] * F[7] - F[4] * F[6],
                              F[2] * F[7] - F[1] * F[8], F[0] * F[8] - F[2] * F[6], F[1] * F[6] - F[0] * F[7],
                              F[1] * F[5] - F[2] * F[4], F[2] * F[3] - F[0] * F[5], F[0] * F[4] - F[1] * F[3]};
    for (int i = 0; i < n_pressures; ++i) {
      system.residual[i] += w * N[i] * (J - 1 - pressure / law_->bulk_modulus());
      for (int j = 0; j < n_pressures; ++j)
        system.mass[n_pressures * i + j] += w * N[i] * N[j] / law_->bulk_modulus();
    }
    CellVector dJ;
    for (int a = 0; a < n_cell_nodes; ++a)
      for (int m = 0; m < 3; ++m)
        dJ[3 * a + m] = cofactor[3 * m] * G[a][0] + cofactor[3 * m + 1] * G[a][1] + cofactor[3 * m + 2] * G[a][2];
    for (int i = 0; i < n_pressures; ++i)
      for (int j = 0; j < n_cell_values; ++j)
        system.coupling[i * n_cell_values + j] += w * N[i] * dJ[j];
  }
  return system;
}

void ElasticWork::solve_pressures(Cell &cell, const CellVector &u) const
{
  const auto increment = pressure_system(cell, u).increment(nullptr);
  for (int i = 0; i < n_pressures; ++i)
    cell.pressure[i] += increment[i];
}

void ElasticWork::begin_step(const State &start, const Step &step)
{
  viscosity_ = 2 * law_->shear_modulus() * relaxation_time_ / step.dt;
  for (auto &cell : cells_) {
    const auto u = local(cell, start.displacement);
    if (mixed_)
      solve_pressures(cell, u);
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
    CellVector r{};
    for (int q = 0; q < n_points; ++q) {
      const auto &G = cell.quadrature.gradient[q];
      const Matrix3 F = deformation_gradient(G, u);
      const Voigt S = material(cell, q, right_cauchy_green(F)).stress;
      Matrix3 P{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          for (int k = 0; k < 3; ++k)
            P[3 * i + j] += cell.quadrature.weight[q] * F[3 * i + k] * S[voigt_index[k][j]];
      for (int a = 0; a < n_cell_nodes; ++a)
        for (int i = 0; i < 3; ++i)
          r[3 * a + i] += P[3 * i] * G[a][0] + P[3 * i + 1] * G[a][1] + P[3 * i + 2] * G[a][2];
    }
    if (mixed_) { // condensed: R_u + L^T M^-1 R_p
      const auto system = pressure_system(cell, u);
      const auto increment = system.increment(nullptr);
      for (int i = 0; i < n_pressures; ++i)
        for (int j = 0; j < n_cell_values; ++j)
          r[j] += system.coupling[i * n_cell_values + j] * increment[i];
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
    if (mixed_) { // + L^T M^-1 L
      auto system = pressure_system(cell, u);
      invert_spd(n_pressures, system.mass.data());
      std::array<double, n_pressures * n_cell_values> ML{};
      add_transposed_product(n_pressures, n_cell_values, n_pressures, system.mass.data(), system.coupling.data(),
                             ML.data());
      add_transposed_product(n_cell_values, n_cell_values, n_pressures, system.coupling.data(), ML.data(), K.data());
    }
    out.add_tangent(discretization_.mesh().cells[cell.index], K);
  }
}

void ElasticWork::advance(const State &from, std::span<const double> increment, double fraction)
{
  for (auto &cell : cells_) {
    const auto u = local(cell, from.displacement), du = local(cell, increment);
    std::array<double, n_pressures> dp{};
    if (mixed_)
      dp = pressure_system(cell, u).increment(&du);
    for (int q = 0; q < n_points; ++q) {
      const auto &G = cell.quadrature.gradient[q];
      const Matrix3 F = deformation_gradient(G, u);
      const Voigt C = right_cauchy_green(F);
      const auto point = material(cell, q, C);
      const Voigt dS = multiply(point.tangent, strain_increment(F, gradient(G, du)));
      const double J = std::sqrt(determinant(C));
      const Voigt A = inverse(C);
      for (int i = 0; i < 6; ++i) {
        double change = point.stress[i] + dS[i] - cell.stress[q][i];
        for (int k = 0; k < n_pressures; ++k)
          change += J * A[i] * cell.pressure_shape[q][k] * dp[k];
        cell.stress[q][i] += fraction * change;
      }
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
