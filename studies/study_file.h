// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include "studies/field_describer.h"
#include "studies/study.h"
#include "studies/toml_document.h"
#include <string>
#include <vector>

namespace ballonet::studies
{

/// A study file with its `--set` overrides: the one way from text to a Study.
class StudyFile
{
public:
  /// Reads and checks the file. Throws InputError.
  static StudyFile open(const std::string &file, const std::vector<Override> &overrides = {});

  /// The same for a text; `file` is its name in messages and the place relative paths start from.
  StudyFile(std::string file, std::string text, std::vector<Override> overrides = {});

  const Study &study() const { return study_; }
  const optimize::DesignSpace &space() const { return space_; }

  /// The study with the variables at the values of a design, set as by `--set`. Checks keys, units and ranges, which
  /// cannot fail for a design of the space, but not how parameters go together: that is for the mesh to find out.
  Study with(const optimize::Design &design) const;

private:
  /// The study with one variable at its extreme values.
  void check_extremes(std::size_t i, const TomlDocument &document) const;

  std::string file_, text_;
  std::vector<Override> overrides_;
  Study study_;
  optimize::DesignSpace space_;
};

/// Every key of a study with its value, in internal units: reading it gives the same study and the same text.
std::string resolved_text(const Study &study);

/// All keys of all kinds of actuators.
std::vector<KeyDescription> describe_all_keys();

/// All keys of a given study, list elements and named tables one by one.
std::vector<KeyDescription> describe_keys(const Study &study);

} // namespace ballonet::studies
