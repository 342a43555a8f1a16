// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/history_file.h"
#include "solver/discretization.h"
#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace ballonet::solver
{

namespace
{

/// The node in the middle of a face belongs to no other face: it tells how many cells share it.
Node middle(const Mesh &mesh, Face face) { return face_nodes(mesh, face)[4]; }

/// Faces of one cell only, without those of the hidden surface.
std::vector<Face> exposed_faces(const Mesh &mesh, const std::string &hidden)
{
  std::vector<int> cells_at(mesh.nodes.size());
  for (std::uint32_t c = 0; c < mesh.cells.size(); ++c)
    for (std::uint32_t f = 0; f < 6; ++f)
      ++cells_at[middle(mesh, {c, f})];
  for (const auto &surface : mesh.surfaces)
    if (surface.name == hidden)
      for (const auto &face : surface.faces)
        cells_at[middle(mesh, face)] = 0;
  std::vector<Face> faces;
  for (std::uint32_t c = 0; c < mesh.cells.size(); ++c)
    for (std::uint32_t f = 0; f < 6; ++f)
      if (cells_at[middle(mesh, {c, f})] == 1)
        faces.push_back({c, f});
  return faces;
}

} // namespace

HistoryFile::HistoryFile(const std::string &path, const Mesh &mesh, const std::string &hidden, bool append,
                         int last_step)
    : mesh_(mesh),
      file_(path, append && std::filesystem::exists(path) ? Hdf5File::Mode::append : Hdf5File::Mode::create)
{
  std::vector<int> index(mesh.nodes.size(), -1);
  for (const auto &face : exposed_faces(mesh, hidden)) {
    const auto nodes = face_nodes(mesh, face);
    for (const auto node : nodes)
      if (index[node] < 0) {
        index[node] = points_.size();
        points_.push_back(node);
      }
    for (const int corner : {0, 1, 3, 4}) { // four quadrilaterals per face
      for (const int step : {0, 1, 4, 3})
        faces_.push_back(index[nodes[corner + step]]);
      face_body_.push_back(mesh.cell_body[face.cell]);
    }
  }
  if (file_.has("/surface/faces"))
    drop_after(last_step);
  else
    write_surface();
}

void HistoryFile::write_surface()
{
  std::string bodies;
  for (const auto &body : mesh_.bodies)
    bodies += (bodies.empty() ? "" : ",") + body;
  file_.create_group("/surface");
  file_.create_group("/states");
  file_.create_group("/critical_points");
  file_.write_attribute("/surface", "bodies", bodies);
  file_.write("/surface/faces", faces_, 4);
  file_.write("/surface/face_body", face_body_);
  file_.flush();
}

void HistoryFile::drop_after(int last_step)
{
  for (const auto &name : file_.names("/states"))
    if (std::stoi(name) > last_step)
      file_.remove("/states/" + name);
  for (const auto &name : file_.names("/critical_points"))
    if (const std::string object = "/critical_points/" + name; file_.read_attribute(object, "step") > last_step)
      file_.remove(object);
}

std::string HistoryFile::group(int step)
{
  char name[32];
  std::snprintf(name, sizeof name, "/states/%06d", step);
  return name;
}

void HistoryFile::add(int step, const State &state, const std::vector<double> &cell_stress,
                      const std::map<std::string, double> &attributes)
{
  std::vector<float> nodal(mesh_.nodes.size()), stress;
  for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
    for (const auto node : mesh_.cells[c])
      nodal[node] = std::max<float>(nodal[node], cell_stress[c]);
  for (const auto node : points_)
    stress.push_back(nodal[node]);
  const std::string name = group(step);
  file_.create_group(name);
  file_.write(name + "/points", positions(state), 3);
  file_.write(name + "/stress", stress);
  for (const auto &[key, value] : attributes)
    file_.write_attribute(name, key, value);
  file_.flush();
}

std::vector<float> HistoryFile::at_surface(const std::vector<double> &field) const
{
  std::vector<float> values;
  for (const auto node : points_)
    values.insert(values.end(), &field[3 * node], &field[3 * node] + 3);
  return values;
}

std::vector<float> HistoryFile::positions(const State &state) const
{
  auto points = at_surface(state.displacement);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] += mesh_.nodes[points_[i / 3]][i % 3];
  return points;
}

void HistoryFile::add_critical_point(const std::string &kind, const State &state, const std::vector<double> &mode,
                                     const std::map<std::string, double> &facts)
{
  char name[32];
  std::snprintf(name, sizeof name, "/critical_points/%04zu", file_.names("/critical_points").size() + 1);
  file_.create_group(name);
  file_.write(std::string(name) + "/points", positions(state), 3);
  file_.write(std::string(name) + "/mode", at_surface(mode), 3);
  file_.write_attribute(name, "kind", kind);
  for (const auto &[key, value] : facts)
    file_.write_attribute(name, key, value);
  file_.flush();
}

} // namespace ballonet::solver
