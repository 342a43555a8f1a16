// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study.h"
#include "studies/toml_document.h"

namespace ballonet::studies
{

/// What no single field can know: references between blocks, files, and what this version can do. Throws InputError
/// placed at the key in the document.
void check_study(const Study &study, const TomlDocument &document);

} // namespace ballonet::studies
