// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/variables.h"
#include "studies/quantity.h"
#include "studies/study_file.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

std::string without_index(const std::string &key) { return key.ends_with(']') ? key.substr(0, key.rfind('[')) : key; }

/// The description of the varied key; `path` is the key of the variable in the document ("variable[0]").
KeyDescription find_key(const Study &study, const TomlDocument &document, const std::string &path,
                        const std::string &key)
{
  const auto rows = describe_keys(study);
  std::vector<std::string> known;
  for (const KeyDescription &row : rows) {
    const bool of_list = row.key == without_index(key) && row.type == "list of quantities";
    if ((row.key == key || of_list) && !row.unit.empty() && row.type != "list of three quantities")
      return row;
    known.push_back(row.key);
    if (row.key == key)
      throw document.error(path + ".key", "\"" + key + "\"", "a key whose value is one number", "it is a " + row.type);
  }
  const std::string hint = nearest_hint(key, known);
  throw document.error(path + ".key", "\"" + key + "\"", "a key of this study",
                       hint.starts_with("nearest") ? hint : "see `ballonet describe`");
}

/// The number a setting of a variable stands for.
double number_of(const std::string &text, const std::string &unit, const TomlDocument &document,
                 const std::string &path)
{
  try {
    return parse_quantity(text, unit);
  } catch (const QuantityError &e) {
    throw document.error(path, "\"" + text + "\"", e.what());
  }
}

optimize::Variable resolve(const Variable &v, const Study &study, const TomlDocument &document, const std::string &path)
{
  const KeyDescription description = find_key(study, document, path, v.key);
  optimize::Variable variable;
  variable.key = v.key;
  variable.unit = description.unit;
  variable.integer = description.type == "whole number";
  for (const std::string &text : v.values)
    variable.values.push_back(number_of(text, variable.unit, document, path + ".values"));
  if (variable.values.empty()) {
    if (v.min.empty() || v.max.empty())
      throw document.error(path, "neither min and max nor values", "both min and max, or a list of values");
    variable.min = number_of(v.min, variable.unit, document, path + ".min");
    variable.max = number_of(v.max, variable.unit, document, path + ".max");
    if (!(variable.min < variable.max))
      throw document.error(path + ".min", v.min, "less than max = " + v.max);
  } else if (!v.min.empty() || !v.max.empty())
    throw document.error(path, "min or max together with values", "either both min and max, or a list of values");
  return variable;
}

} // namespace

optimize::DesignSpace design_space(const Study &study, const TomlDocument &document)
{
  std::vector<optimize::Variable> variables;
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    variables.push_back(resolve(study.variables[i], study, document, "variable[" + std::to_string(i) + "]"));
  try {
    return optimize::DesignSpace(std::move(variables));
  } catch (const std::invalid_argument &e) {
    throw document.error("variable", e.what(), "variables with different keys, finite bounds and different values");
  }
}

std::vector<double> extreme_values(const optimize::Variable &variable)
{
  return variable.values.empty() ? std::vector<double>{variable.min, variable.max} : variable.values;
}

std::vector<Override> overrides_with(std::vector<Override> overrides, const std::vector<VariableValue> &values)
{
  for (const auto &[variable, value] : values)
    overrides.push_back({variable.key, variable.integer ? std::to_string(static_cast<long long>(value))
                                                        : format_quantity(value, variable.unit)});
  return overrides;
}

} // namespace ballonet::studies
