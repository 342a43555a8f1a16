// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/content_hash.h"
#include "studies/field_writer.h"
#include "studies/reduced_parameters.h"
#include "studies/toml_document.h"
#include <array>
#include <cstdint>
#include <cstdio>

namespace ballonet::studies
{

std::string text_hash(std::string_view text)
{
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const unsigned char c : text)
    hash = (hash ^ c) * 0x100000001b3ULL;
  std::array<char, 17> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

std::string content_hash(const Study &study)
{
  const ModelKind model = study.method.model;
  Study physics = model == ModelKind::reduced ? reduced_view(study) : study;
  physics.title = {};
  physics.method = {};
  physics.method.model = model;
  physics.variables.clear();
  physics.objective.reset();
  physics.constraints.clear();
  physics.output = {};
  physics.parallel = {};
  physics.path.checkpoint_every = solver::Path{}.checkpoint_every;
  if (!physics.actuator.file.empty())
    physics.actuator.file = text_hash(read_text_file(physics.actuator.file));
  return text_hash(write_fields(physics));
}

} // namespace ballonet::studies
