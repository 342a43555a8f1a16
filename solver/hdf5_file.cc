// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/hdf5_file.h"
#include <stdexcept>

namespace ballonet::solver
{

Hdf5File::Hdf5File(std::string path, Mode mode) : path_(std::move(path))
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // errors are reported by exceptions
  file_ = mode == Mode::create   ? H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
          : mode == Mode::append ? H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)
                                 : H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  check(file_, "open it");
}

Hdf5File::~Hdf5File() { H5Fclose(file_); }

hid_t Hdf5File::check(hid_t id, const std::string &action) const
{
  if (id < 0)
    throw std::runtime_error("HDF5 file " + path_ + ": cannot " + action);
  return id;
}

void Hdf5File::create_group(const std::string &group)
{
  H5Gclose(check(H5Gcreate2(file_, group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "create group " + group));
}

bool Hdf5File::has(const std::string &object) const
{
  for (std::size_t slash = object.find('/', 1); slash != std::string::npos; slash = object.find('/', slash + 1))
    if (H5Lexists(file_, object.substr(0, slash).c_str(), H5P_DEFAULT) <= 0)
      return false;
  return H5Lexists(file_, object.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5File::names(const std::string &group) const
{
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char *name, const H5L_info_t *, void *list) -> herr_t {
    static_cast<std::vector<std::string> *>(list)->emplace_back(name);
    return 0;
  };
  check(H5Literate_by_name(file_, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names, H5P_DEFAULT),
        "list " + group);
  return names;
}

void Hdf5File::remove(const std::string &object)
{
  check(H5Ldelete(file_, object.c_str(), H5P_DEFAULT), "remove " + object);
}

void Hdf5File::write(const std::string &dataset, hid_t type, const void *values, std::size_t size, std::size_t columns)
{
  const hsize_t extent[2] = {size / columns, columns};
  const hid_t space = H5Screate_simple(columns == 1 ? 1 : 2, extent, nullptr);
  const hid_t id = check(H5Dcreate2(file_, dataset.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         "create data set " + dataset);
  check(H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "write data set " + dataset);
  H5Dclose(id);
  H5Sclose(space);
}

void Hdf5File::write(const std::string &dataset, std::span<const double> values, std::size_t columns)
{
  write(dataset, H5T_NATIVE_DOUBLE, values.data(), values.size(), columns);
}

void Hdf5File::write(const std::string &dataset, std::span<const float> values, std::size_t columns)
{
  write(dataset, H5T_NATIVE_FLOAT, values.data(), values.size(), columns);
}

void Hdf5File::write(const std::string &dataset, std::span<const int> values, std::size_t columns)
{
  write(dataset, H5T_NATIVE_INT, values.data(), values.size(), columns);
}

void Hdf5File::write_attribute(const std::string &object, const std::string &name, double value)
{
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t id = check(H5Acreate_by_name(file_, object.c_str(), name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                                           H5P_DEFAULT, H5P_DEFAULT),
                         "create attribute " + name);
  H5Awrite(id, H5T_NATIVE_DOUBLE, &value);
  H5Aclose(id);
  H5Sclose(space);
}

void Hdf5File::write_attribute(const std::string &object, const std::string &name, const std::string &value)
{
  const hid_t space = H5Screate(H5S_SCALAR), type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, value.size() + 1);
  const hid_t id =
      check(H5Acreate_by_name(file_, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
            "create attribute " + name);
  H5Awrite(id, type, value.c_str());
  H5Aclose(id);
  H5Tclose(type);
  H5Sclose(space);
}

std::vector<double> Hdf5File::read(const std::string &dataset) const
{
  const hid_t id = check(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), "open data set " + dataset);
  const hid_t space = H5Dget_space(id);
  std::vector<double> values(H5Sget_simple_extent_npoints(space));
  check(H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read data set " + dataset);
  H5Sclose(space);
  H5Dclose(id);
  return values;
}

double Hdf5File::read_attribute(const std::string &object, const std::string &name) const
{
  const hid_t id =
      check(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "open attribute " + name);
  double value = 0;
  check(H5Aread(id, H5T_NATIVE_DOUBLE, &value), "read attribute " + name);
  H5Aclose(id);
  return value;
}

std::string Hdf5File::read_text_attribute(const std::string &object, const std::string &name) const
{
  const hid_t id =
      check(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), "open attribute " + name);
  const hid_t type = H5Aget_type(id);
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(id, type, text.data()), "read attribute " + name);
  H5Tclose(type);
  H5Aclose(id);
  return text.c_str(); // up to the zero at its end
}

std::map<std::string, double> Hdf5File::number_attributes(const std::string &object) const
{
  const hid_t id = check(H5Oopen(file_, object.c_str(), H5P_DEFAULT), "open " + object);
  std::map<std::string, double> numbers;
  for (int i = 0; i < H5Aget_num_attrs(id); ++i) {
    const hid_t attribute = H5Aopen_by_idx(id, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(attribute);
    char name[256];
    H5Aget_name(attribute, sizeof name, name);
    if (H5Tget_class(type) == H5T_FLOAT)
      H5Aread(attribute, H5T_NATIVE_DOUBLE, &numbers[name]);
    H5Tclose(type);
    H5Aclose(attribute);
  }
  H5Oclose(id);
  return numbers;
}

void Hdf5File::flush() { check(H5Fflush(file_, H5F_SCOPE_GLOBAL), "write it"); }

} // namespace ballonet::solver
