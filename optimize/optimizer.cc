// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/optimizer.h"
#include <algorithm>
#include <nlopt.hpp>

namespace ballonet::optimize
{

namespace
{
/// NLopt asks for the objective and each constraint of a point separately; a point is requested once.
class PointCache
{
public:
  explicit PointCache(const Coroutine<Point, Answer>::Yield &yield) : yield_(yield) {}

  const Answer &at(unsigned n, const double *x)
  {
    if (point_.size() != n || !std::equal(point_.begin(), point_.end(), x)) {
      Point point(x, x + n);
      answer_ = yield_(point);
      point_ = std::move(point);
    }
    return answer_;
  }

private:
  const Coroutine<Point, Answer>::Yield &yield_;
  Point point_;
  Answer answer_;
};

struct ConstraintCallback {
  PointCache *cache;
  std::size_t index;
};

/// An exception in a callback becomes a forced stop: NLopt is C and cannot be unwound.
double cost_callback(unsigned n, const double *x, double *, void *data)
{
  try {
    return static_cast<PointCache *>(data)->at(n, x).cost;
  } catch (...) {
    throw nlopt::forced_stop();
  }
}

double constraint_callback(unsigned n, const double *x, double *, void *data)
{
  const auto &callback = *static_cast<const ConstraintCallback *>(data);
  try {
    return callback.cache->at(n, x).constraints.at(callback.index);
  } catch (...) {
    throw nlopt::forced_stop();
  }
}

void set_stopping(nlopt::opt &opt, const OptimizerSettings &settings)
{
  if (settings.x_tolerance > 0)
    opt.set_xtol_abs(settings.x_tolerance);
  if (settings.f_tolerance > 0)
    opt.set_ftol_rel(settings.f_tolerance);
  opt.set_maxeval(settings.max_requests);
}

nlopt::opt make_plain(const std::string &name, const OptimizerSettings &settings)
{
  nlopt::opt opt(name.c_str(), static_cast<unsigned>(settings.start.size()));
  set_stopping(opt, settings);
  opt.set_initial_step(settings.initial_step);
  if (settings.population > 0)
    opt.set_population(static_cast<unsigned>(settings.population));
  return opt;
}

nlopt::opt make(const Algorithm &algorithm, const OptimizerSettings &settings)
{
  const nlopt::opt plain = make_plain(algorithm.name, settings);
  if (settings.n_constraints == 0 || algorithm.constraints == Constraints::native)
    return plain;
  nlopt::opt augmented(nlopt::AUGLAG, plain.get_dimension());
  set_stopping(augmented, settings);
  augmented.set_local_optimizer(plain);
  return augmented;
}

std::string words_for(nlopt::result result, const OptimizerSettings &settings)
{
  switch (result) {
  case nlopt::FTOL_REACHED:
    return "the objective changes by less than the tolerance f_tolerance";
  case nlopt::XTOL_REACHED:
    return "the step is below the tolerance x_tolerance";
  case nlopt::MAXEVAL_REACHED:
    return "the algorithm asked " + std::to_string(settings.max_requests) + " times, mostly for known designs";
  default:
    return "the algorithm has finished";
  }
}

std::string optimize(nlopt::opt &opt, const OptimizerSettings &settings)
{
  Point x = settings.start;
  double cost = 0;
  try {
    return words_for(opt.optimize(x, cost), settings);
  } catch (const nlopt::roundoff_limited &) {
    return "rounding errors allow no further progress";
  } catch (const nlopt::forced_stop &) {
    return "stopped from outside";
  } catch (const std::runtime_error &error) {
    return std::string("the algorithm gave up: ") + error.what();
  }
}
} // namespace

Optimizer::Optimizer(const Algorithm &algorithm, OptimizerSettings settings)
    : algorithm_(algorithm), settings_(std::move(settings)), coroutine_([this](const Run::Yield &yield) { run(yield); })
{
}

void Optimizer::run(const Run::Yield &yield)
{
  nlopt::srand(settings_.seed); // of this thread
  PointCache cache(yield);
  std::vector<ConstraintCallback> constraints;
  for (std::size_t i = 0; i < settings_.n_constraints; ++i)
    constraints.push_back({&cache, i});

  nlopt::opt opt = make(algorithm_, settings_);
  opt.set_lower_bounds(0.0);
  opt.set_upper_bounds(1.0);
  opt.set_min_objective(cost_callback, &cache);
  for (ConstraintCallback &constraint : constraints)
    opt.add_inequality_constraint(constraint_callback, &constraint, settings_.constraint_tolerance);
  stop_reason_ = optimize(opt, settings_);
}

} // namespace ballonet::optimize
