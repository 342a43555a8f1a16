// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/design.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace ballonet::optimize
{

namespace
{
[[noreturn]] void reject(const Variable &variable, const std::string &why)
{
  throw std::invalid_argument("variable '" + variable.key + "': " + why);
}

/// Rounded to 12 significant digits. Unlike snprintf, the same in every locale.
double rounded(double value)
{
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 11).ptr;
  std::from_chars(text, end, value);
  return value;
}

void check_values(const Variable &variable)
{
  for (const double value : variable.values)
    if (!std::isfinite(value))
      reject(variable, "a value of the list is not a finite number");
  if (std::set<double>(variable.values.begin(), variable.values.end()).size() != variable.values.size())
    reject(variable, "a value is listed twice");
}

void check_bounds(const Variable &variable)
{
  if (!std::isfinite(variable.min) || !std::isfinite(variable.max))
    reject(variable, "min and max must be finite numbers");
  if (!(variable.min < variable.max))
    reject(variable, "min = " + std::to_string(variable.min) + " must be below max = " + std::to_string(variable.max));
  if (variable.integer && (variable.min != std::round(variable.min) || variable.max != std::round(variable.max)))
    reject(variable, "an integer variable needs whole numbers as min and max");
}
} // namespace

DesignSpace::DesignSpace(std::vector<Variable> variables) : variables_(std::move(variables))
{
  std::set<std::string> keys;
  for (const Variable &variable : variables_) {
    if (variable.key.empty())
      throw std::invalid_argument("a variable has no key");
    if (!keys.insert(variable.key).second)
      reject(variable, "is there twice");
    if (variable.values.empty())
      check_bounds(variable);
    else
      check_values(variable);
  }
}

bool DesignSpace::is_discrete(std::size_t i) const { return variables_[i].integer || !variables_[i].values.empty(); }

std::size_t DesignSpace::n_choices(std::size_t i) const
{
  const Variable &variable = variables_[i];
  if (!variable.values.empty())
    return variable.values.size();
  return variable.integer ? static_cast<std::size_t>(variable.max - variable.min) + 1 : 0;
}

double DesignSpace::choice_coordinate(std::size_t i, std::size_t choice) const
{
  return (static_cast<double>(choice) + 0.5) / static_cast<double>(n_choices(i));
}

double DesignSpace::choice_value(std::size_t i, std::size_t choice) const
{
  const Variable &variable = variables_[i];
  return variable.values.empty() ? variable.min + static_cast<double>(choice) : variable.values[choice];
}

std::size_t DesignSpace::n_combinations() const
{
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
  std::size_t product = 1;
  for (std::size_t i = 0; i < size(); ++i)
    if (is_discrete(i))
      product = product > most / n_choices(i) ? most : product * n_choices(i);
  return product;
}

Design DesignSpace::design_at(const Point &point) const
{
  Design design(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const double coordinate = std::clamp(point.at(i), 0.0, 1.0);
    if (is_discrete(i)) {
      const std::size_t m = n_choices(i);
      design[i] = choice_value(i, std::min(m - 1, static_cast<std::size_t>(coordinate * static_cast<double>(m))));
    } else {
      const Variable &variable = variables_[i];
      const double value = variable.min + coordinate * (variable.max - variable.min);
      design[i] = std::clamp(rounded(value), variable.min, variable.max);
    }
  }
  return design;
}

Point DesignSpace::point_of(const Design &design) const
{
  if (design.size() != size())
    throw std::invalid_argument("a design has " + std::to_string(design.size()) + " values for " +
                                std::to_string(size()) + " variables");
  Point point(size());
  for (std::size_t i = 0; i < size(); ++i)
    point[i] = coordinate_of(i, design[i]);
  return point;
}

double DesignSpace::coordinate_of(std::size_t i, double value) const
{
  const Variable &variable = variables_[i];
  for (std::size_t choice = 0; choice < n_choices(i); ++choice)
    if (value == choice_value(i, choice))
      return choice_coordinate(i, choice);
  if (is_discrete(i))
    reject(variable, std::to_string(value) + " is not one of its values");
  if (!(value >= variable.min && value <= variable.max))
    reject(variable, std::to_string(value) + " is outside [" + std::to_string(variable.min) + ", " +
                         std::to_string(variable.max) + "]");
  return (value - variable.min) / (variable.max - variable.min);
}

} // namespace ballonet::optimize
