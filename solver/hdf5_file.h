// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <hdf5.h>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace ballonet::solver
{

/// A serial HDF5 file, open as long as this object lives. Every function throws std::runtime_error naming the file.
class Hdf5File
{
public:
  enum class Mode { create, append, read };
  Hdf5File(std::string path, Mode mode);
  ~Hdf5File();
  Hdf5File(const Hdf5File &) = delete;
  Hdf5File &operator=(const Hdf5File &) = delete;

  void create_group(const std::string &group);
  bool has(const std::string &object) const;
  /// Names in a group, ascending.
  std::vector<std::string> names(const std::string &group) const;
  void remove(const std::string &object);
  /// Data sets of rows x columns (one-dimensional when columns == 1).
  void write(const std::string &dataset, std::span<const double> values, std::size_t columns = 1);
  void write(const std::string &dataset, std::span<const float> values, std::size_t columns = 1);
  void write(const std::string &dataset, std::span<const int> values, std::size_t columns = 1);
  void write_attribute(const std::string &object, const std::string &name, double value);
  void write_attribute(const std::string &object, const std::string &name, const std::string &value);
  std::vector<double> read(const std::string &dataset) const;
  double read_attribute(const std::string &object, const std::string &name) const;
  std::string read_text_attribute(const std::string &object, const std::string &name) const;
  /// All attributes of an object that are numbers.
  std::map<std::string, double> number_attributes(const std::string &object) const;
  void flush();

private:
  void write(const std::string &dataset, hid_t type, const void *values, std::size_t size, std::size_t columns);
  hid_t check(hid_t id, const std::string &action) const;
  std::string path_;
  hid_t file_;
};

} // namespace ballonet::solver
