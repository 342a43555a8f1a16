// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/field_files.h"
#include "solver/discretization.h"
#include "studies/atomic_file.h"
#include <cstdio>
#include <sstream>

namespace ballonet::studies
{
namespace
{

namespace fs = std::filesystem;

std::string name_of(int step)
{
  char name[32];
  std::snprintf(name, sizeof name, "step_%06d", step);
  return name;
}

bool is_first(MPI_Comm communicator)
{
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank == 0;
}

} // namespace

FieldFiles::FieldFiles(fs::path folder, const std::vector<Row> &rows, MPI_Comm communicator)
    : folder_(std::move(folder)), writes_(is_first(communicator))
{
  if (writes_) {
    fs::create_directories(folder_ / "fields");
    keep_files_of(rows);
  }
  MPI_Barrier(communicator); // the folder is there
}

void FieldFiles::keep_files_of(const std::vector<Row> &rows)
{
  std::map<std::string, Row> wanted;
  for (const Row &row : rows)
    wanted[name_of(static_cast<int>(value_of(row, "step"))) + ".vtu"] = row;
  const std::vector<fs::directory_entry> entries(fs::directory_iterator(folder_ / "fields"), {});
  for (const fs::directory_entry &entry : entries)
    if (const auto found = wanted.find(entry.path().filename().string()); found != wanted.end())
      times_[static_cast<int>(value_of(found->second, "step"))] = value_of(found->second, "time_s");
    else
      fs::remove(entry.path());
  write_collection();
}

void FieldFiles::add(int step, const solver::State &state, const std::vector<double> &stresses,
                     const solver::Equilibrium &equilibrium)
{
  equilibrium.discretization().write_vtu((folder_ / "fields").string(), name_of(step), state, stresses, "stress_MPa");
  if (!writes_)
    return;
  times_[step] = state.time;
  write_collection();
}

void FieldFiles::write_collection() const
{
  std::ostringstream text;
  text.precision(17);
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (const auto &[step, time] : times_)
    text << "<DataSet timestep=\"" << time << "\" part=\"0\" file=\"fields/" << name_of(step) << ".vtu\"/>\n";
  text << "</Collection>\n</VTKFile>\n";
  write_atomically(folder_ / "fields.pvd", text.str());
}

} // namespace ballonet::studies
