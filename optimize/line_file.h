// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ballonet::optimize
{

/// A text file that only grows, by whole lines, each on disk before append() returns. A line that was being written
/// when the process or the machine stopped is cut off at the next opening. Open in one process at a time (POSIX record
/// lock, which ends with the process however it ends).
class LineFile
{
public:
  /// Opens or creates the file and reads its lines. Throws std::system_error if it cannot be opened, read or locked.
  explicit LineFile(const std::filesystem::path &path);
  ~LineFile();
  LineFile(const LineFile &) = delete;
  LineFile &operator=(const LineFile &) = delete;

  /// The complete lines found on opening, without their ends.
  const std::vector<std::string> &lines_on_opening() const { return lines_; }

  /// Length in bytes of the torn last line cut off on opening, 0 if the file was whole.
  std::size_t torn_bytes() const { return torn_bytes_; }

  /// Appends a line and waits until it is on disk. Throws std::invalid_argument if the line contains a line break and
  /// std::system_error if it cannot be written (the file is then as before).
  void append(std::string_view line);

private:
  void lock() const;
  void read();
  void write_at_end(std::string_view text);

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::size_t size_ = 0; // bytes of whole lines
  std::size_t torn_bytes_ = 0;
  std::vector<std::string> lines_;
};

} // namespace ballonet::optimize
