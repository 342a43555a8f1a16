// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study.h"
#include <string>
#include <string_view>

namespace ballonet::studies
{

/// Identity of a simulation, 16 hexadecimal digits: hash of all resolved inputs that can change its result, with the
/// content of a mesh file in place of its name, and the model that computes it; of the reduced model, those inputs it
/// takes notice of. Title, method, variables, output and parallel use do not count.
std::string content_hash(const Study &study);

/// FNV-1a of 64 bits (Fowler, Noll, Vo), 16 hexadecimal digits.
std::string text_hash(std::string_view text);

} // namespace ballonet::studies
