// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace reference
{

using Row = std::map<std::string, double>;

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double kPa = 1e-3;

/// A table of tests/data/reduced: one map from column name to value per row.
inline std::vector<Row> read_table(const std::string &name)
{
  std::ifstream file(std::string(BALLONET_SOURCE_DIR) + "/tests/data/reduced/" + name);
  if (!file)
    throw std::runtime_error("cannot read " + name);
  const auto split = [](const std::string &line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');)
      cells.push_back(cell);
    return cells;
  };
  std::string line;
  std::getline(file, line);
  const auto header = split(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const auto cells = split(line);
    Row row;
    for (std::size_t i = 0; i < header.size(); ++i)
      row[header[i]] = std::stod(cells.at(i));
    rows.push_back(row);
  }
  return rows;
}

} // namespace reference
