// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/parameters.h"
#include <cmath>
#include <stdexcept>
#include <string>

namespace ballonet::solver::reduced
{
namespace
{

/// Visits all fields and refuses the first one outside its range.
class RangeCheck
{
public:
  void quantity(const char *name, double value, const char *unit, double min, double max, const char *)
  {
    if (!(value >= min && value <= max)) // also false for NaN
      throw std::invalid_argument(prefix_ + name + " = " + std::to_string(value) + " " + unit + ": allowed is " +
                                  std::to_string(min) + " to " + std::to_string(max));
  }
  void quantity(const char *name, const std::optional<double> &value, const char *unit, double min, double max,
                const char *help)
  {
    if (value)
      quantity(name, *value, unit, min, max, help);
  }
  void count(const char *name, int value, int min, int max, const char *help)
  {
    quantity(name, static_cast<double>(value), "1", min, max, help);
  }
  void flag(const char *, bool, const char *) {}

  template <class Group>
  void group(const char *name, const Group &group, const char *)
  {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + ".";
    Group::fields(group, *this);
    prefix_ = outer;
  }

private:
  std::string prefix_;
};

} // namespace

void check(const Parameters &parameters)
{
  RangeCheck ranges;
  Parameters::fields(parameters, ranges);
  const Balloon &balloon = parameters.balloon;
  if (balloon.wall >= balloon.diameter / 2)
    throw std::invalid_argument("balloon.wall must be less than half of balloon.diameter");
  if (balloon.diameter / 2 >= parameters.ribs.inner_radius)
    throw std::invalid_argument("balloon.diameter must be less than twice ribs.inner_radius");
}

} // namespace ballonet::solver::reduced
