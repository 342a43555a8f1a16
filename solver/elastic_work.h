// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/cell_stiffness.h"
#include "solver/material.h"
#include "solver/virtual_work.h"

namespace ballonet::solver
{

/// Stored and viscous work of the cells of one body.
///
/// Displacement form (Q2): residual with the stress of the strain, geometric stiffness with a stress carried as a
/// Newton quantity of its own (mixed-integration-point Newton, Magisano, Leonetti & Garcea 2017). Mixed form (Q2/P-1):
/// perturbed Lagrangian psi_iso(C) + p (J - 1) - p^2 / (2 kappa) with four element pressures that are condensed from
/// the tangent but carried from iteration to iteration. Viscosity (Kelvin-Voigt, objective): S_v = 2 mu (tau / dt) A (E
/// - E_n) A with A = C_n^-1.
class ElasticWork : public VirtualWork
{
public:
  ElasticWork(const Discretization &discretization, std::uint32_t body, std::unique_ptr<MaterialLaw> law,
              double relaxation_time, bool mixed);

  void begin_step(const State &start, const Step &step) override;
  double energy(const State &state) const override;
  void residual(const State &state, Assembly &out) const override;
  void tangent(const State &state, Assembly &out) const override;
  void advance(const State &from, std::span<const double> increment, double fraction) override;
  double largest_step(const State &state, std::span<const double> increment) const override;

  /// Elastic (without viscous) energy of this rank's cells, N mm.
  double stored_energy(const State &state) const;
  /// Viscous work done since the start of the step, N mm, of this rank's cells.
  double dissipated(const State &state) const;
  /// Largest von Mises stress (Cauchy) over the Gauss points of each owned cell is written to `stress[cell]`, MPa.
  void stresses(const State &state, std::vector<double> &stress) const;
  /// Smallest det F over the Gauss points of this rank's cells.
  double smallest_volume_ratio(const State &state) const;

private:
  static constexpr int n_pressures = 4;
  using Pressures = std::array<double, n_pressures>;
  struct Cell {
    std::uint32_t index;
    CellQuadrature quadrature;
    std::array<Pressures, n_points> pressure_shape;             ///< 1 and centred X, Y, Z
    std::array<double, n_pressures * n_pressures> inverse_mass; ///< M^-1 with M = int N N^T / kappa
    Pressures pressure{};
    std::array<Voigt, n_points> stress{};        ///< Newton quantity of the geometric stiffness
    std::array<Voigt, n_points> start_strain{};  ///< E_n
    std::array<Voigt, n_points> start_inverse{}; ///< A = C_n^-1
  };

  MaterialLaw::Point material(const Cell &cell, int point, const Voigt &C, bool viscous = true) const;
  void invert_mass(Cell &cell) const;
  /// Value at a Gauss point of the linear pressure with these coefficients.
  static double pressure_at(const Cell &cell, int point, const Pressures &coefficients);
  /// p J A, the stress of a pressure.
  static Voigt stress_of(double pressure, const Voigt &C);
  /// M^-1 (R_p + L du) with R_p = int N (J - 1 - p / kappa), L = d R_p / d u: the pressures' change that belongs to du.
  Pressures pressure_increment(const Cell &cell, const CellVector &u, const CellVector *du = nullptr) const;
  /// K += L^T M^-1 L
  void add_condensed_pressures(const Cell &cell, const CellVector &u, CellMatrix &K) const;
  CellVector local(const Cell &cell, std::span<const double> field) const;

  const Discretization &discretization_;
  std::unique_ptr<MaterialLaw> law_;
  double relaxation_time_;
  bool mixed_;
  double viscosity_ = 0; ///< 2 mu tau / dt of the step, MPa
  std::vector<Cell> cells_;
};

} // namespace ballonet::solver
