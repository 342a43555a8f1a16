// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/field_describer.h"

namespace ballonet::studies
{

std::string FieldDescriber::joined(const std::vector<std::string> &words, const std::string &separator)
{
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : separator) + word;
  return text.empty() ? "not set" : text;
}

std::string FieldDescriber::quantity_text(double value, const std::string &unit)
{
  return std::isinf(value) ? "unlimited" : format_quantity(value, unit);
}

std::string FieldDescriber::list_text(const std::vector<double> &values, const std::string &unit)
{
  std::vector<std::string> texts;
  for (const double value : values)
    texts.push_back(quantity_text(value, unit));
  return joined(texts, ", ");
}

void FieldDescriber::quantities(const std::string &key, const std::vector<double> &member, const std::string &unit,
                                double min, double max, const std::string &help)
{
  add(key, "list of quantities", unit, range_text(min, max, unit), list_text(member, unit), help);
}

} // namespace ballonet::studies
