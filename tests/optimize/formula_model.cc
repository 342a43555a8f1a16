// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/optimize/formula_model.h"
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace ballonet::optimize
{

namespace
{
std::string text_of(double value)
{
  char text[64];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

double number_of(const std::string &text)
{
  char *end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0)
    throw std::invalid_argument("'" + text + "' is not a number");
  return value;
}

std::vector<std::string> split(const std::string &text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

std::string write(const Evaluation &evaluation)
{
  std::string line = evaluation.hash + "\t" + FormulaModel::text_of(evaluation.design) + "\t" +
                     std::string(word_of(evaluation.status)) + "\t" + evaluation.reason + "\t" +
                     text_of(evaluation.seconds);
  for (const auto &[name, value] : evaluation.responses)
    line += "\t" + name + "\t" + text_of(value);
  return line;
}

Evaluation read(const std::string &line)
{
  const std::vector<std::string> fields = split(line, '\t');
  if (fields.size() < 5 || fields.size() % 2 == 0)
    throw std::invalid_argument("not an evaluation");
  Evaluation evaluation;
  evaluation.hash = fields[0];
  for (const std::string &value : split(fields[1], ' '))
    evaluation.design.push_back(number_of(value));
  evaluation.status = status_of(fields[2]);
  evaluation.reason = fields[3];
  evaluation.seconds = number_of(fields[4]);
  for (std::size_t i = 5; i < fields.size(); i += 2)
    evaluation.responses[fields[i]] = number_of(fields[i + 1]);
  return evaluation;
}
} // namespace

std::string FormulaModel::text_of(const Design &design)
{
  std::string text;
  for (const double value : design) {
    if (!text.empty())
      text += ' ';
    text += optimize::text_of(value);
  }
  return text;
}

Evaluation ok(std::map<std::string, double> responses)
{
  Evaluation evaluation;
  evaluation.status = Status::ok;
  evaluation.responses = std::move(responses);
  return evaluation;
}

Evaluation failure(Status status, std::string reason)
{
  Evaluation evaluation;
  evaluation.status = status;
  evaluation.reason = std::move(reason);
  return evaluation;
}

LineFormat tab_separated() { return {write, read}; }

TemporaryFolder::TemporaryFolder()
{
  std::string name = (std::filesystem::temp_directory_path() / "ballonet-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("no temporary folder");
  path_ = name;
}

DesignSpace square() { return DesignSpace({{.key = "x", .min = -2, .max = 2}, {.key = "y", .min = -2, .max = 2}}); }

} // namespace ballonet::optimize
