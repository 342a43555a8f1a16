// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/linear_system.h"
#include "solver/petsc_call.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver
{

namespace
{

std::vector<PetscInt> blocks(const Discretization &discretization, std::span<const Node> nodes)
{
  std::vector<PetscInt> result;
  for (const auto node : nodes)
    result.push_back(discretization.block(node));
  return result;
}

} // namespace

class LinearSystem::ResidualAssembly : public Assembly
{
public:
  ResidualAssembly(const LinearSystem &system, Vec vector) : system_(system), vector_(vector) {}
  void add_residual(std::span<const Node> nodes, std::span<const double> values) override
  {
    const auto rows = blocks(system_.discretization_, nodes);
    petsc(VecSetValuesBlocked(vector_, rows.size(), rows.data(), values.data(), ADD_VALUES));
  }
  void add_tangent(std::span<const Node>, std::span<const double>) override {}

private:
  const LinearSystem &system_;
  Vec vector_;
};

class LinearSystem::TangentAssembly : public Assembly
{
public:
  TangentAssembly(const LinearSystem &system, const State &state) : system_(system), state_(state) {}
  void add_residual(std::span<const Node>, std::span<const double>) override {}
  void add_tangent(std::span<const Node> nodes, std::span<const double> values) override
  {
    const auto rows = blocks(system_.discretization_, nodes);
    const std::size_t n = 3 * nodes.size();
    local_.assign(values.begin(), values.end());
    lift_.assign(n, 0);
    bool lifted = false;
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t equation = 3 * nodes[j / 3] + j % 3;
      const double target = system_.prescribed_[equation];
      if (std::isnan(target))
        continue;
      const double increment = state_.displacement[equation] - target;
      for (std::size_t i = 0; i < n; ++i) {
        lift_[i] += local_[i * n + j] * increment;
        local_[i * n + j] = local_[j * n + i] = 0;
      }
      lifted = lifted || increment != 0;
    }
    petsc(MatSetValuesBlocked(system_.matrix_, rows.size(), rows.data(), rows.size(), rows.data(), local_.data(),
                              ADD_VALUES));
    if (lifted)
      petsc(VecSetValuesBlocked(system_.lift_, rows.size(), rows.data(), lift_.data(), ADD_VALUES));
  }

private:
  const LinearSystem &system_;
  const State &state_;
  std::vector<double> local_, lift_;
};

LinearSystem::LinearSystem(const Discretization &discretization)
    : discretization_(discretization), prescribed_(3 * discretization.n_nodes(), std::nan("")), pattern_(discretization)
{
  lift_ = create_vector();
  Vec vector = create_vector();
  petsc(VecScatterCreateToAll(vector, &to_all_, &sequential_));
  petsc(VecDestroy(&vector));
}

LinearSystem::~LinearSystem()
{
  MatDestroy(&matrix_);
  VecDestroy(&lift_);
  VecDestroy(&sequential_);
  VecScatterDestroy(&to_all_);
}

Vec LinearSystem::create_vector() const
{
  const auto [first, last] = discretization_.owned_blocks();
  Vec vector;
  petsc(VecCreateMPI(discretization_.comm(), 3 * (last - first), PETSC_DETERMINE, &vector));
  petsc(VecSetBlockSize(vector, 3));
  return vector;
}

void LinearSystem::rebuild_pattern()
{
  const auto [first, last] = discretization_.owned_blocks();
  std::vector<Node> node_of(last - first);
  for (Node node = 0; node < discretization_.n_nodes(); ++node)
    if (const int b = discretization_.block(node); b >= first && b < last)
      node_of[b - first] = node;
  std::vector<PetscInt> diagonal(last - first), off(last - first);
  std::vector<std::vector<PetscInt>> columns(last - first);
  for (int row = first; row < last; ++row) {
    for (const auto other : pattern_.row(node_of[row - first]))
      if (const int column = discretization_.block(other); column >= row) {
        ++(column < last ? diagonal : off)[row - first];
        columns[row - first].push_back(column);
      }
    std::sort(columns[row - first].begin(), columns[row - first].end());
  }
  petsc(MatDestroy(&matrix_));
  petsc(MatCreateSBAIJ(discretization_.comm(), 3, 3 * (last - first), 3 * (last - first), PETSC_DETERMINE,
                       PETSC_DETERMINE, 0, diagonal.data(), 0, off.data(), &matrix_));
  petsc(MatSetOption(matrix_, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
  for (int row = first; row < last; ++row) {
    const auto &c = columns[row - first];
    const std::vector<double> zeros(9 * c.size());
    petsc(MatSetValuesBlocked(matrix_, 1, &row, c.size(), c.data(), zeros.data(), INSERT_VALUES));
  }
  petsc(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
  petsc(MatSetOption(matrix_, MAT_NEW_NONZERO_LOCATION_ERR, PETSC_TRUE));
  factor_.set_matrix(matrix_);
  pattern_changed_ = false;
}

template <class Visit>
void LinearSystem::for_held(const Visit &visit) const
{
  const auto [first, last] = discretization_.owned_blocks();
  for (Node node = 0; node < discretization_.n_nodes(); ++node)
    if (const int b = discretization_.block(node); b >= first && b < last)
      for (int d = 0; d < 3; ++d)
        if (const double target = prescribed_[3 * node + d]; !std::isnan(target))
          visit(3 * (b - first) + d, target, 3 * node + d);
}

void LinearSystem::assemble(const std::function<void(Assembly &)> &add, Vec sum) const
{
  petsc(VecSet(sum, 0));
  ResidualAssembly assembly(*this, sum);
  add(assembly);
  petsc(VecAssemblyBegin(sum));
  petsc(VecAssemblyEnd(sum));
}

double LinearSystem::hold(const State &state, Vec residual) const
{
  double *values, largest = 0;
  petsc(VecGetArray(residual, &values));
  for_held([&](int i, double target, std::size_t equation) {
    values[i] = state.displacement[equation] - target;
    largest = std::max(largest, std::abs(values[i]));
  });
  petsc(VecRestoreArray(residual, &values));
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_DOUBLE, MPI_MAX, discretization_.comm());
  return largest;
}

double LinearSystem::clear_held(Vec vector) const
{
  double *values, square = 0;
  petsc(VecGetArray(vector, &values));
  for_held([&](int i, double, std::size_t) {
    square += values[i] * values[i];
    values[i] = 0;
  });
  petsc(VecRestoreArray(vector, &values));
  MPI_Allreduce(MPI_IN_PLACE, &square, 1, MPI_DOUBLE, MPI_SUM, discretization_.comm());
  return std::sqrt(square);
}

void LinearSystem::sum_tangents(const std::vector<VirtualWork *> &works, const State &state)
{
  petsc(MatZeroEntries(matrix_));
  petsc(VecSet(lift_, 0));
  TangentAssembly assembly(*this, state);
  for (const auto *work : works)
    work->tangent(state, assembly);
  const int offset = 3 * discretization_.owned_blocks().first;
  for_held([&](int i, double, std::size_t) { petsc(MatSetValue(matrix_, offset + i, offset + i, 1, ADD_VALUES)); });
  petsc(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  petsc(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
  petsc(VecAssemblyBegin(lift_));
  petsc(VecAssemblyEnd(lift_));
}

bool LinearSystem::factorise(const std::vector<VirtualWork *> &works, const State &state)
{
  if (pattern_changed_)
    rebuild_pattern();
  sum_tangents(works, state);
  return factor_.compute();
}

void LinearSystem::precondition(const std::vector<VirtualWork *> &works, const State &state)
{
  sum_tangents(works, state);
  factor_.precondition();
}

void LinearSystem::keep_factor()
{
  petsc(VecSet(lift_, 0));
  factor_.keep();
}

void LinearSystem::solve_held(Vec b, Vec x)
{
  Vec rhs;
  petsc(VecDuplicate(b, &rhs));
  petsc(VecCopy(b, rhs));
  petsc(VecAXPY(rhs, -1, lift_));
  const double *residual;
  double *values;
  petsc(VecGetArrayRead(b, &residual));
  petsc(VecGetArray(rhs, &values));
  for_held([&](int i, double, std::size_t) { values[i] = residual[i]; }); // no force of one held value on another
  petsc(VecRestoreArray(rhs, &values));
  petsc(VecRestoreArrayRead(b, &residual));
  solve(rhs, x);
  petsc(VecDestroy(&rhs));
}

void LinearSystem::scatter(const std::vector<double> &field, Vec vector) const
{
  const auto [first, last] = discretization_.owned_blocks();
  double *values;
  petsc(VecGetArray(vector, &values));
  for (Node node = 0; node < discretization_.n_nodes(); ++node)
    if (const int b = discretization_.block(node); b >= first && b < last)
      std::copy_n(&field[3 * node], 3, values + 3 * (b - first));
  petsc(VecRestoreArray(vector, &values));
}

void LinearSystem::gather(Vec vector, std::vector<double> &field) const
{
  petsc(VecScatterBegin(to_all_, vector, sequential_, INSERT_VALUES, SCATTER_FORWARD));
  petsc(VecScatterEnd(to_all_, vector, sequential_, INSERT_VALUES, SCATTER_FORWARD));
  const double *values;
  petsc(VecGetArrayRead(sequential_, &values));
  for (std::size_t node = 0; node < discretization_.n_nodes(); ++node)
    std::copy_n(values + 3 * discretization_.block(node), 3, &field[3 * node]);
  petsc(VecRestoreArrayRead(sequential_, &values));
}

} // namespace ballonet::solver
