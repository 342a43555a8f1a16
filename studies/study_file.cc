// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/study_file.h"
#include "studies/field_reader.h"
#include "studies/field_writer.h"
#include "studies/quantity.h"
#include "studies/reduced_checks.h"
#include "studies/study_checks.h"
#include "studies/variables.h"
#include <algorithm>
#include <filesystem>

namespace ballonet::studies
{
namespace
{

/// Removes coefficients the law does not have: what a built-in material of the same name left behind.
void drop_unused_coefficients(std::vector<solver::Material> &materials)
{
  for (solver::Material &material : materials)
    if (material.law == solver::Law::saint_venant) {
      material.c10.reset();
      material.d1.reset();
    }
}

ActuatorKind read_kind(const TomlDocument &document)
{
  Actuator actuator;
  const toml::node *table = document.root().get("actuator");
  if (table && table->is_table()) {
    FieldReader reader(document, *table->as_table(), "actuator.");
    Actuator::kind_field(actuator, reader);
  }
  return actuator.kind;
}

Study read_study(const TomlDocument &document)
{
  Study study = default_study(read_kind(document));
  read_fields(document, study);
  drop_unused_coefficients(study.materials);
  const auto folder = std::filesystem::path(document.file()).parent_path();
  if (!study.actuator.file.empty())
    study.actuator.file = std::filesystem::absolute(folder / study.actuator.file).lexically_normal();
  return study;
}

/// The block [run] of a resolved file tells how it was run; it is no input.
TomlDocument parse(const std::string &file, const std::string &text, const std::vector<Override> &overrides)
{
  TomlDocument document(file, text, overrides);
  document.remove("run");
  return document;
}

} // namespace

StudyFile StudyFile::open(const std::string &file, const std::vector<Override> &overrides)
{
  return {file, read_text_file(file), overrides};
}

StudyFile::StudyFile(std::string file, std::string text, std::vector<Override> overrides)
    : file_(std::move(file)), text_(std::move(text)), overrides_(std::move(overrides))
{
  const TomlDocument document = parse(file_, text_, overrides_);
  study_ = read_study(document);
  check_study(study_, document);
  space_ = design_space(study_, document);
  for (std::size_t i = 0; i < space_.size(); ++i)
    check_extremes(i, document);
}

void StudyFile::check_extremes(std::size_t i, const TomlDocument &document) const
{
  std::vector<Study> extremes;
  for (const double value : extreme_values(space_.variable(i)))
    extremes.push_back(read_study(parse(file_, text_, overrides_with(overrides_, {{space_.variable(i), value}}))));
  if (study_.method.model != ModelKind::fem)
    check_reduced_variable(extremes, space_.variable(i).key, document, "variable[" + std::to_string(i) + "].key");
}

Study StudyFile::with(const optimize::Design &design) const
{
  std::vector<VariableValue> values;
  for (std::size_t i = 0; i < space_.size(); ++i)
    values.push_back({space_.variable(i), design.at(i)});
  return read_study(parse(file_, text_, overrides_with(overrides_, values)));
}

std::string resolved_text(const Study &study) { return write_fields(study); }

std::vector<KeyDescription> describe_keys(const Study &study)
{
  FieldDescriber describer(FieldDescriber::Mode::actual);
  Study::fields(study, describer);
  return describer.rows();
}

std::vector<KeyDescription> describe_all_keys()
{
  std::vector<KeyDescription> rows;
  for (const ActuatorKind kind : {ActuatorKind::pebs, ActuatorKind::balloon, ActuatorKind::mesh}) {
    FieldDescriber describer(FieldDescriber::Mode::schema);
    const Study study = default_study(kind);
    Study::fields(study, describer);
    for (const KeyDescription &row : describer.rows())
      if (std::none_of(rows.begin(), rows.end(), [&](const auto &known) { return known.key == row.key; }))
        rows.push_back(row);
  }
  return rows;
}

} // namespace ballonet::studies
