// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/history_table.h"
#include "studies/atomic_file.h"
#include "studies/word_columns.h"
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

std::vector<std::string> split(const std::string &line)
{
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');)
    words.push_back(word);
  return words;
}

std::string header_of(const Row &row)
{
  std::string line;
  for (const auto &[name, value] : row)
    line += (line.empty() ? "" : ",") + name;
  return line + "\n";
}

/// A number that reads back bit by bit, or a word.
std::string cell_text(const std::string &column, double value)
{
  if (const auto words = words_of(column); !words.empty())
    return words.at(static_cast<std::size_t>(value));
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

double cell_value(const std::string &column, const std::string &text)
{
  return words_of(column).empty() ? std::stod(text) : number_of(column, text);
}

std::string line_of(const Row &row)
{
  std::string line;
  for (const auto &[name, value] : row)
    line += (line.empty() ? "" : ",") + cell_text(name, value);
  return line + "\n";
}

} // namespace

std::vector<Row> read_history(const std::filesystem::path &file)
{
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const auto names = split(line);
  std::vector<Row> rows;
  while (std::getline(stream, line) && !stream.eof()) { // a line without end was cut short
    const auto words = split(line);
    if (words.size() != names.size())
      break;
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i)
      row.emplace_back(names[i], cell_value(names[i], words[i]));
    rows.push_back(std::move(row));
  }
  return rows;
}

HistoryTable::HistoryTable(const std::filesystem::path &file, const std::vector<Row> &rows)
{
  std::string text;
  if (!rows.empty())
    text = header_ = header_of(rows.front());
  for (const Row &row : rows)
    text += line_of(row);
  write_atomically(file, text);
  stream_.open(file, std::ios::app);
}

void HistoryTable::append(const Row &row)
{
  if (header_.empty())
    stream_ << (header_ = header_of(row));
  if (header_of(row) != header_)
    throw std::logic_error("the columns of the history changed along the path");
  if (!(stream_ << line_of(row) << std::flush))
    throw std::runtime_error("history.csv cannot be written");
}

} // namespace ballonet::studies
