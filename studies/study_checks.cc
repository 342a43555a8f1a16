// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/study_checks.h"
#include "optimize/algorithm.h"
#include "solver/material.h"
#include "studies/problem_checks.h"
#include "studies/response_names.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

void check_kinds(const Study &study, const TomlDocument &document)
{
  if (study.actuator.kind == ActuatorKind::pba || study.actuator.kind == ActuatorKind::gripper)
    throw document.error("actuator.kind", "an actuator that is not available in this version", "pebs | balloon | mesh");
  const MethodKind kind = study.method.kind;
  if (kind != MethodKind::solve && kind != MethodKind::sample && kind != MethodKind::optimize)
    throw document.error("method.kind", "a method that is not available in this version", "solve | sample | optimize");
  if (study.method.model != ModelKind::fem && study.actuator.kind != ActuatorKind::pebs)
    throw document.error("method.model", "the reduced model", "fem: only actuator.kind = \"pebs\" has a reduced model");
}

void check_materials(const Study &study, const TomlDocument &document)
{
  for (const solver::Material &m : study.materials) {
    const std::string key = "material." + m.name;
    if (m.law == solver::Law::neo_hookean && m.c10 && m.youngs_modulus)
      throw document.error(key, "c10 together with youngs_modulus",
                           "either c10 and d1 or youngs_modulus and poisson_ratio",
                           "a built-in material keeps what the block does not change; use another name");
    try {
      const auto law = solver::make_material(m);
      if (!(law->shear_modulus() > 0 && law->bulk_modulus() > 0))
        throw document.error(key, "a material without stiffness", "positive shear and bulk moduli");
    } catch (const std::invalid_argument &e) {
      throw document.error(key, e.what(), "all coefficients of the law");
    }
  }
}

void check_response(const std::string &name, const std::string &key, const Study &study, const TomlDocument &document)
{
  const auto known = response_names(study);
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw document.error(key, "\"" + name + "\"", "a response of this study", nearest_hint(name, known));
}

void check_wishes(const Study &study, const TomlDocument &document)
{
  if (study.objective)
    check_response(study.objective->response, "objective.response", study, document);
  for (std::size_t i = 0; i < study.constraints.size(); ++i) {
    const Constraint &c = study.constraints[i];
    const std::string key = "constraint[" + std::to_string(i) + "]";
    check_response(c.response, key + ".response", study, document);
    if (!c.min && !c.max)
      throw document.error(key, "neither min nor max", "at least one of min and max");
    if (c.min && c.max && *c.min > *c.max)
      throw document.error(key + ".min", "a min above max", "min at most max");
  }
}

void check_algorithm(const Study &study, const TomlDocument &document)
{
  const std::string &name = study.method.search.algorithm;
  try {
    const optimize::Algorithm &algorithm = optimize::algorithm_named(name);
    if (study.method.kind == MethodKind::optimize)
      optimize::check(algorithm, study.variables.size(), study.constraints.size());
  } catch (const std::invalid_argument &e) {
    throw document.error("method.algorithm", "\"" + name + "\"", "an algorithm that can do this", e.what());
  }
}

void check_method(const Study &study, const TomlDocument &document)
{
  const bool solve = study.method.kind == MethodKind::solve;
  if (solve && !study.variables.empty())
    throw document.error("variable", "variables in a study that only solves", "method.kind = sample | optimize");
  if (!solve && study.variables.empty())
    throw document.error("method.kind", "a method without variables", "at least one [[variable]]");
  if (study.method.kind == MethodKind::optimize && !study.objective)
    throw document.error("method.kind", "optimize without an objective", "a block [objective]");
  check_algorithm(study, document);
}

} // namespace

void check_study(const Study &study, const TomlDocument &document)
{
  check_kinds(study, document);
  check_materials(study, document);
  if (study.actuator.kind == ActuatorKind::mesh)
    check_problem(study, document);
  else
    check_actuator(study, document);
  check_wishes(study, document);
  check_method(study, document);
}

} // namespace ballonet::studies
