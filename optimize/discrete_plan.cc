// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/discrete_plan.h"
#include "optimize/sampling.h"

namespace ballonet::optimize
{

namespace
{
std::vector<std::size_t> coordinates(const DesignSpace &space, bool with_discrete)
{
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < space.size(); ++i)
    if (with_discrete || !space.is_discrete(i))
      list.push_back(i);
  return list;
}

DiscreteTreatment choose(const DesignSpace &space, std::size_t n_continuous, std::size_t limit, std::size_t starts,
                         std::size_t budget)
{
  if (n_continuous == space.size())
    return DiscreteTreatment::none;
  const std::size_t n = space.n_combinations();
  if (n_continuous == 0)
    return n <= budget ? DiscreteTreatment::exhaustive : DiscreteTreatment::rounded;
  const std::size_t per_run = 5 * n_continuous + 1;
  return n <= limit && n * starts * per_run <= budget ? DiscreteTreatment::enumerated : DiscreteTreatment::rounded;
}

std::string describe(DiscreteTreatment treatment, std::size_t n)
{
  const std::string combinations = std::to_string(n) + " combinations of discrete variables";
  switch (treatment) {
  case DiscreteTreatment::none:
    return "no discrete variables";
  case DiscreteTreatment::exhaustive:
    return "exhaustive: all " + combinations + " evaluated";
  case DiscreteTreatment::enumerated:
    return "enumerated: each of " + combinations + " searched on its own";
  default:
    return "rounded: " + combinations + " are too many to search each; the points of the algorithm are rounded";
  }
}
} // namespace

DiscretePlan plan_discrete(const DesignSpace &space, std::size_t limit, std::size_t starts, std::size_t budget)
{
  DiscretePlan plan;
  const std::vector<std::size_t> continuous = coordinates(space, false);
  plan.treatment = choose(space, continuous.size(), limit, starts, budget);
  plan.description = describe(plan.treatment, space.n_combinations());
  if (plan.treatment == DiscreteTreatment::exhaustive || plan.treatment == DiscreteTreatment::enumerated) {
    plan.free = continuous;
    plan.combinations = full_factorial(space, std::vector<std::size_t>(space.size(), 1));
  } else {
    plan.free = coordinates(space, true);
    plan.combinations = {Point(space.size(), 0.5)};
  }
  return plan;
}

} // namespace ballonet::optimize
