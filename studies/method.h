// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/search.h"
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

/// What computes a design: the finite element simulation, the reduced model of a PEBS, or each of them.
enum class ModelKind { fem, reduced, both };
enum class Sampling { latin_hypercube, full_factorial };

/// What is done with the variables.
struct Method {
  MethodKind kind = MethodKind::solve;
  ModelKind model = ModelKind::fem;
  Sampling sampling = Sampling::latin_hypercube;
  optimize::SearchOptions search;

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
             "one simulation, a sample of the variables, or a search");
    v.choice(
        "model", self.model, {{"fem", ModelKind::fem}, {"reduced", ModelKind::reduced}, {"both", ModelKind::both}},
        "what computes a design: finite elements, or (pebs only) the reduced model, which takes milliseconds, or both");
    v.choice("sampling", self.sampling,
             {{"latin_hypercube", Sampling::latin_hypercube}, {"full_factorial", Sampling::full_factorial}},
             "sample: how max_evaluations designs are spread");
    optimize::SearchOptions::fields(self.search, v);
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
