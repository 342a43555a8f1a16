// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/modes.h"
#include "solver/petsc_call.h"
#include <algorithm>
#include <cmath>
#include <slepceps.h>

namespace ballonet::solver
{

namespace
{

/// The symmetric operator D S D on free displacements, with D^2 = M and the compliance S = K^-1, or with the volume
/// held
///   S = K^-1 - r r^T / (G . r),  r = K^-1 G.
/// Its eigenvalues are 1 / omega^2; massless and held displacements have the eigenvalue 0.
class Flexibility
{
public:
  Flexibility(LinearSystem &system, const std::vector<double> &mass, Vec volume_gradient);
  ~Flexibility();
  Flexibility(const Flexibility &) = delete;
  Flexibility &operator=(const Flexibility &) = delete;

  Mat shell() const { return shell_; }
  /// Number of negative eigenvalues.
  int negatives() const { return system_.negative_pivots() - (gradient_ && gained_ < 0); }
  /// The shape that belongs to an eigenvector.
  std::vector<double> shape(Vec eigenvector) const;

private:
  void apply_compliance(Vec force, Vec displacement) const;
  void apply(Vec in, Vec out) const;

  LinearSystem &system_;
  std::size_t n_values_;
  Vec root_mass_, force_, displacement_, response_;
  Vec gradient_;
  double gained_ = 0; ///< G . r, mm^3/MPa
  Mat shell_ = nullptr;
};

Flexibility::Flexibility(LinearSystem &system, const std::vector<double> &mass, Vec volume_gradient)
    : system_(system), n_values_(3 * mass.size()), gradient_(volume_gradient)
{
  for (Vec *vector : {&root_mass_, &force_, &displacement_, &response_})
    *vector = system.create_vector();
  std::vector<double> roots(n_values_);
  for (std::size_t i = 0; i < n_values_; ++i)
    roots[i] = std::sqrt(mass[i / 3]);
  system.scatter(roots, root_mass_);
  system.clear_held(root_mass_);
  if (gradient_) {
    system.solve(gradient_, response_);
    petsc(VecDot(gradient_, response_, &gained_));
  }
  PetscInt local;
  petsc(VecGetLocalSize(root_mass_, &local));
  petsc(MatCreateShell(PetscObjectComm(reinterpret_cast<PetscObject>(root_mass_)), local, local, PETSC_DETERMINE,
                       PETSC_DETERMINE, this, &shell_));
  const auto multiply = [](Mat shell, Vec in, Vec out) {
    void *self;
    const PetscErrorCode code = MatShellGetContext(shell, &self);
    static_cast<const Flexibility *>(self)->apply(in, out);
    return code;
  };
  PetscErrorCode (*const function)(Mat, Vec, Vec) = multiply;
  petsc(MatShellSetOperation(shell_, MATOP_MULT, reinterpret_cast<void (*)()>(function)));
}

Flexibility::~Flexibility()
{
  MatDestroy(&shell_);
  for (Vec *vector : {&root_mass_, &force_, &displacement_, &response_})
    VecDestroy(vector);
}

void Flexibility::apply_compliance(Vec force, Vec displacement) const
{
  system_.solve(force, displacement);
  if (!gradient_)
    return;
  double volume;
  petsc(VecDot(gradient_, displacement, &volume));
  petsc(VecAXPY(displacement, -volume / gained_, response_));
}

void Flexibility::apply(Vec in, Vec out) const
{
  petsc(VecPointwiseMult(force_, root_mass_, in));
  apply_compliance(force_, displacement_);
  petsc(VecPointwiseMult(out, root_mass_, displacement_));
}

std::vector<double> Flexibility::shape(Vec eigenvector) const
{
  petsc(VecPointwiseMult(force_, root_mass_, eigenvector));
  apply_compliance(force_, displacement_);
  std::vector<double> shape(n_values_);
  system_.gather(displacement_, shape);
  double largest = 0;
  for (std::size_t i = 0; i < n_values_; i += 3)
    largest = std::max(largest, std::hypot(shape[i], shape[i + 1], shape[i + 2]));
  for (double &value : shape)
    value /= largest;
  return shape;
}

/// Adds the modes of `count` eigenvalues from one end of the spectrum; those of eigenvalue 0 are none.
void add_modes(const Flexibility &flexibility, EPSWhich end, int count, std::vector<Mode> &modes)
{
  if (count <= 0)
    return;
  PetscInt size, converged;
  petsc(MatGetSize(flexibility.shell(), &size, nullptr));
  const PetscInt wanted = std::min<PetscInt>(count, size);
  EPS eps;
  petsc(EPSCreate(PetscObjectComm(reinterpret_cast<PetscObject>(flexibility.shell())), &eps));
  petsc(EPSSetOperators(eps, flexibility.shell(), nullptr));
  petsc(EPSSetProblemType(eps, EPS_HEP));
  petsc(EPSSetType(eps, EPSKRYLOVSCHUR));
  petsc(EPSSetWhichEigenpairs(eps, end));
  petsc(EPSSetDimensions(eps, wanted, PETSC_DEFAULT, PETSC_DEFAULT));
  petsc(EPSSetTolerances(eps, 1e-10, 1000));
  petsc(EPSSolve(eps));
  petsc(EPSGetConverged(eps, &converged));
  Vec vector;
  petsc(MatCreateVecs(flexibility.shell(), &vector, nullptr));
  double first = 0;
  for (PetscInt i = 0; i < std::min(wanted, converged); ++i) {
    double value;
    petsc(EPSGetEigenpair(eps, i, &value, nullptr, vector, nullptr));
    first = i == 0 ? value : first;
    if (std::abs(value) > 1e-13 * std::abs(first))
      modes.push_back({1 / value, flexibility.shape(vector)});
  }
  petsc(VecDestroy(&vector));
  petsc(EPSDestroy(&eps));
  if (converged < wanted)
    throw std::runtime_error("only " + std::to_string(converged) + " of " + std::to_string(wanted) +
                             " vibration modes could be found");
}

} // namespace

double Mode::frequency() const { return omega_squared > 0 ? std::sqrt(omega_squared) / (2 * M_PI) : 0; }

double Mode::growth_rate() const { return omega_squared < 0 ? std::sqrt(-omega_squared) : 0; }

std::vector<Mode> lowest_modes(LinearSystem &system, const std::vector<double> &mass, Vec volume_gradient, int count)
{
  const Flexibility flexibility(system, mass, volume_gradient);
  std::vector<Mode> modes;
  add_modes(flexibility, EPS_SMALLEST_REAL, flexibility.negatives(), modes);
  add_modes(flexibility, EPS_LARGEST_REAL, count - static_cast<int>(modes.size()), modes);
  std::sort(modes.begin(), modes.end(), [](const Mode &a, const Mode &b) { return a.omega_squared < b.omega_squared; });
  modes.resize(std::min<std::size_t>(modes.size(), count));
  return modes;
}

} // namespace ballonet::solver
