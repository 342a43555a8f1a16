// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/measurement.h"
#include <filesystem>
#include <fstream>
#include <vector>

namespace ballonet::studies
{

/// The rows of a history.csv, words by their numbers; empty without such a file. An incomplete last row is left out.
std::vector<Row> read_history(const std::filesystem::path &file);

/// A history.csv that grows by a row per step. Columns of words are written as such.
class HistoryTable
{
public:
  /// Replaces the file by `rows`. Throws std::system_error.
  HistoryTable(const std::filesystem::path &file, const std::vector<Row> &rows);

  /// Throws std::logic_error if the columns are not those of the first row, std::runtime_error if the disk is full.
  void append(const Row &row);

private:
  std::ofstream stream_;
  std::string header_;
};

} // namespace ballonet::studies
