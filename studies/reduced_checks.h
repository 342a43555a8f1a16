// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study.h"
#include "studies/toml_document.h"

namespace ballonet::studies
{

/// Whether the reduced model can compute a PEBS study, whose materials exist: no key it knows nothing of, all in its
/// range. Throws InputError placed at the key in the document.
void check_reduced(const Study &study, const TomlDocument &document);

/// Whether it can follow a variable: knows its values, and, if there is no simulation beside it, takes notice of it at
/// all. `extremes`: the study at extreme values of the variable; `place`: its key in the document.
void check_reduced_variable(const std::vector<Study> &extremes, const std::string &variable,
                            const TomlDocument &document, const std::string &place);

} // namespace ballonet::studies
