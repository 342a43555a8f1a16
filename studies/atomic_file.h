// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <filesystem>
#include <string>

namespace ballonet::studies
{

/// Replaces a file by a new text in one move: a kill at any moment leaves the old file or the new one, whole and on
/// disk. Throws std::system_error naming the file.
void write_atomically(const std::filesystem::path &file, const std::string &text);

/// The same with a file that is written and closed already; it is moved over the other, which may not be there yet.
void move_into_place(const std::filesystem::path &unfinished, const std::filesystem::path &file);

} // namespace ballonet::studies
