// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// A key of the study file that is varied. min, max and values are written as under the key itself.
struct Variable {
  std::string key, min, max;
  std::vector<std::string> values;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("key", self.key, "the varied key, such as actuator.balloon.diameter or material.latex.c10");
    v.setting("min", self.min, "smallest value, written as under the key itself");
    v.setting("max", self.max, "largest value");
    v.settings("values", self.values, "instead of min and max: the only allowed values");
  }
};

enum class MethodKind { solve, sample, map, optimize, pareto, calibrate, invert };

/// What is done with the variables.
struct Method {
  MethodKind kind = MethodKind::solve;
  std::string algorithm;
  int max_evaluations = 100;
  int initial = 0;
  int starts = 1;
  int seed = 1;
  double x_tolerance = 1e-3;
  double f_tolerance = 1e-4;
  double time_limit = std::numeric_limits<double>::infinity(); // s

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.choice("kind", self.kind,
             {{"solve", MethodKind::solve},
              {"sample", MethodKind::sample},
              {"map", MethodKind::map},
              {"optimize", MethodKind::optimize},
              {"pareto", MethodKind::pareto},
              {"calibrate", MethodKind::calibrate},
              {"invert", MethodKind::invert}},
             "one simulation, sampling of the variables, or a search");
    v.text("algorithm", self.algorithm, "algorithm of the method; empty: its default");
    v.count("max_evaluations", self.max_evaluations, 1, 10000000,
            "budget of evaluations, repeated designs not counted");
    v.count("initial", self.initial, 0, 10000000, "optimize: sampled designs before the search");
    v.count("starts", self.starts, 1, 1000, "optimize: searches from the best sampled designs, side by side");
    v.count("seed", self.seed, 0, 2147483647, "of all random numbers; the same seed gives the same designs");
    v.quantity("x_tolerance", self.x_tolerance, "1", 0, 1, "stop: variables move less than this share of their range");
    v.quantity("f_tolerance", self.f_tolerance, "1", 0, 1, "stop: the objective improves less than this share");
    v.quantity("time_limit", self.time_limit, "s", 0, 1e9, "wall time after which no evaluation is begun");
  }
};

/// A response that has to stay within bounds.
struct Constraint {
  std::string response;
  std::optional<double> min, max; ///< in the unit of the response

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    constexpr double any = std::numeric_limits<double>::infinity();
    v.text("response", self.response, "name of a response");
    v.quantity("min", self.min, "1", -any, any, "smallest allowed value, in the unit of the response's name");
    v.quantity("max", self.max, "1", -any, any, "largest allowed value, likewise");
  }
};

} // namespace ballonet::studies
