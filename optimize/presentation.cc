// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/presentation.h"
#include <algorithm>
#include <cmath>

namespace ballonet::optimize
{

Presentation::Presentation(std::size_t n_bounds, bool takes_constraints)
    : n_bounds_(n_bounds), takes_constraints_(takes_constraints), worst_violations_(n_bounds, 0.0)
{
}

void Presentation::learn(const Point &point, const Assessment &assessment)
{
  if (!assessment.usable)
    return;
  best_cost_ = usable_.empty() ? assessment.cost : std::min(best_cost_, assessment.cost);
  worst_cost_ = usable_.empty() ? assessment.cost : std::max(worst_cost_, assessment.cost);
  for (std::size_t i = 0; i < n_bounds_; ++i)
    worst_violations_[i] = std::max(worst_violations_[i], assessment.violations[i]);
  usable_.push_back(point);
}

Answer Presentation::answer(const Point &point, const Assessment &assessment)
{
  Answer answer;
  if (assessment.usable) {
    answer.cost = assessment.cost;
    answer.constraints = assessment.violations;
    if (takes_constraints_)
      answer.constraints.push_back(-1);
    return answer;
  }
  ++n_substituted_;
  const double distance = distance_to_usable(point);
  if (takes_constraints_) {
    answer.cost = worst_cost_;
    answer.constraints = worst_violations_;
    answer.constraints.push_back(1 + distance);
  } else {
    const double spread = worst_cost_ - best_cost_;
    answer.cost = worst_cost_ + (spread > 0 ? spread : 1) * distance;
  }
  return answer;
}

double Presentation::distance_to_usable(const Point &point) const
{
  const double diagonal = std::sqrt(static_cast<double>(point.size()));
  double nearest = 1;
  for (const Point &other : usable_) {
    double square = 0;
    for (std::size_t i = 0; i < point.size(); ++i)
      square += (point[i] - other[i]) * (point[i] - other[i]);
    nearest = std::min(nearest, std::sqrt(square) / diagonal);
  }
  return nearest;
}

std::string Presentation::description() const
{
  if (takes_constraints_)
    return "a failed evaluation violates an extra constraint by 1 + the distance to the nearest design that succeeded";
  return "a failed evaluation counts as the worst cost so far + its range times the distance to the nearest design "
         "that "
         "succeeded";
}

} // namespace ballonet::optimize
