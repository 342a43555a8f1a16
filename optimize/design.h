// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// A point in the variable space: one value per variable, in the order and units of the variables.
using Design = std::vector<double>;

/// A point in the unit box [0, 1]^n, where sampling and algorithms work.
using Point = std::vector<double>;

/// What may be varied. Continuous between min and max; discrete if it is an integer or has a list of values.
struct Variable {
  std::string key;                 ///< path in the study file, "actuator.balloon.diameter"
  std::string unit = "1";          ///< of min, max and values
  double min = 0, max = 1;         ///< both ends are allowed; not used if values are given
  std::vector<double> values = {}; ///< the only allowed values, if not empty
  bool integer = false;            ///< whole numbers from min to max
};

/// The variables of a study, and the scaling of each to [0, 1]. A discrete variable of m choices divides [0, 1] into m
/// equal cells; a choice stands for its cell and sits at the middle of it.
class DesignSpace
{
public:
  DesignSpace() = default;

  /// Throws std::invalid_argument naming the variable if a key is empty or used twice, a bound or value is not finite,
  /// min is not below max, an integer has fractional bounds, or a value is listed twice.
  explicit DesignSpace(std::vector<Variable> variables);

  std::size_t size() const { return variables_.size(); }
  const Variable &variable(std::size_t i) const { return variables_[i]; }
  bool is_discrete(std::size_t i) const;

  /// Number of choices of a discrete variable, 0 for a continuous one.
  std::size_t n_choices(std::size_t i) const;

  /// Coordinate in [0, 1] of a choice of a discrete variable.
  double choice_coordinate(std::size_t i, std::size_t choice) const;

  /// Number of combinations of all discrete choices, 1 if there are none, at most the largest size_t.
  std::size_t n_combinations() const;

  /// The design at a point. Coordinates outside [0, 1] are moved to the nearest end. Continuous values have 12
  /// significant digits, so that scaling there and back gives the same design on every machine; discrete ones are
  /// rounded to the choice whose cell holds the coordinate.
  Design design_at(const Point &point) const;

  /// The point of a design. Throws std::invalid_argument if a value is NaN, out of bounds or not among the choices.
  Point point_of(const Design &design) const;

private:
  double choice_value(std::size_t i, std::size_t choice) const;
  double coordinate_of(std::size_t i, double value) const;

  std::vector<Variable> variables_;
};

} // namespace ballonet::optimize
