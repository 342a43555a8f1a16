// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/problem_checks.h"
#include "geometry/boundary.h"
#include "geometry/mesh_io.h"
#include "geometry/parameter_check.h"
#include "studies/actuator_pebs.h"
#include "studies/reduced_checks.h"
#include <algorithm>
#include <filesystem>
#include <set>

namespace ballonet::studies
{
namespace
{

void check_material(const std::string &name, const std::string &key, const Study &study, const TomlDocument &document)
{
  std::vector<std::string> known;
  for (const solver::Material &m : study.materials)
    known.push_back(m.name);
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw document.error(key, "\"" + name + "\"", "the name of a [material.X] block", nearest_hint(name, known));
}

std::string element(const std::string &list, std::size_t i) { return list + "[" + std::to_string(i) + "]"; }

/// Reads the mesh file.
geometry::Mesh checked_mesh(const Study &study, const TomlDocument &document)
{
  const std::string &file = study.actuator.file;
  if (file.empty())
    throw document.error("actuator", "kind \"mesh\" without file", "file = \"part.msh\"");
  if (!std::filesystem::is_regular_file(file))
    throw document.error("actuator.file", "\"" + file + "\", which does not exist", "a gmsh file");
  auto mesh = geometry::read_msh(file);
  if (const auto *failure = std::get_if<geometry::MeshFailure>(&mesh))
    throw document.error("actuator.file", "\"" + file + "\"", "a gmsh file of hexahedra", failure->reason);
  return std::get<geometry::Mesh>(std::move(mesh));
}

/// Names of the mesh that the study uses.
class MeshNames
{
public:
  MeshNames(const geometry::Mesh &mesh, const TomlDocument &document) : mesh_(mesh), document_(document) {}

  void check_surface(const std::string &name, const std::string &key) const
  {
    check(name, key, mesh_.surfaces, "a physical surface of the mesh");
  }
  void check_set(const std::string &name, const std::string &key) const
  {
    check(name, key, mesh_.node_sets, "a physical curve or point of the mesh");
  }
  /// `item` names a surface or a set of nodes; `optional`: or neither.
  template <class Item>
  void check_place(const Item &item, const std::string &key, bool optional = false) const
  {
    const bool none = item.surface.empty() && item.nodes.empty(), both = !item.surface.empty() && !item.nodes.empty();
    if (both || (none && !optional))
      throw document_.error(key, both ? "surface together with nodes" : "neither surface nor nodes",
                            "either surface or nodes");
    if (!item.surface.empty())
      check_surface(item.surface, key + ".surface");
    if (!item.nodes.empty())
      check_set(item.nodes, key + ".nodes");
  }
  void check_body(const std::string &name, const std::string &key) const
  {
    check(name, key, mesh_.bodies, "a physical volume of the mesh");
  }

private:
  template <class Named>
  void check(const std::string &name, const std::string &key, const std::vector<Named> &named,
             const std::string &what) const
  {
    std::vector<std::string> known;
    for (const Named &item : named)
      known.push_back(item.name);
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw document_.error(key, "\"" + name + "\"", what, nearest_hint(name, known));
  }

  const geometry::Mesh &mesh_;
  const TomlDocument &document_;
};

void check_bodies(const Study &study, const TomlDocument &document)
{
  if (study.bodies.empty())
    throw document.error("body", "a study of kind mesh without bodies", "a block [[body]] for each physical volume");
  std::set<std::string> names;
  for (std::size_t i = 0; i < study.bodies.size(); ++i) {
    const std::string key = element("body", i);
    check_material(study.bodies[i].material, key + ".material", study, document);
    if (study.bodies[i].name.empty() || !names.insert(study.bodies[i].name).second)
      throw document.error(key, "a body with no name or a name used before", "a name of its own");
  }
}

void check_control(const Study &study, const TomlDocument &document)
{
  if (study.cavities.size() > 1)
    throw document.error("cavity[1]", "a second cavity", "one cavity");
  if (study.cavities.empty() && solver::drives_cavity(study.path.control))
    throw document.error("path.control", "a control that needs a cavity", "load | release, or a block [[cavity]]");
}

/// What a body that is let go cannot do.
void check_release(const Study &study, const TomlDocument &document)
{
  if (study.path.control != solver::Control::release)
    return;
  if (!study.path.inertia)
    throw document.error("path.inertia", "release without inertia", "true: a release is motion with mass");
  for (std::size_t i = 0; i < study.supports.size(); ++i)
    for (const auto &move : study.supports[i].move)
      if (move && *move != 0)
        throw document.error(element("support", i) + ".move", "a moved support under path.control = \"release\"",
                             "supports at rest: they would have to jump");
}

/// What the place of a load cannot carry.
void check_loads(const Study &study, const TomlDocument &document)
{
  for (std::size_t i = 0; i < study.loads.size(); ++i) {
    const solver::Load &load = study.loads[i];
    const bool on_surface = load.pressure != 0 || load.traction != solver::Vector3{};
    if (!load.nodes.empty() && on_surface)
      throw document.error(element("load", i), "a traction or pressure on a set of nodes", "force, or a surface");
    if (load.nodes.empty() && load.force != solver::Vector3{})
      throw document.error(element("load", i) + ".force", "a force on a surface", "traction, or a set of nodes");
  }
}

void check_response(const solver::Response &r, const std::string &key, const Study &study, const TomlDocument &document)
{
  using Kind = solver::ResponseKind;
  const bool located = r.kind == Kind::displacement || r.kind == Kind::position;
  const bool has_place = !r.surface.empty() || !r.nodes.empty();
  if (located && has_place == r.point.has_value())
    throw document.error(key, "not exactly one of surface, nodes and point", "either surface, nodes or point");
  if (r.kind == Kind::reaction && !has_place)
    throw document.error(key, "a reaction without surface or nodes", "a surface or set of nodes that is held");
  const std::vector<std::string> components = {"x", "y", "z", "magnitude"};
  if (std::find(components.begin(), components.end(), r.component) == components.end())
    throw document.error(key + ".component", "\"" + r.component + "\"", "x | y | z | magnitude");
  const auto has_name = [](const auto &name) { return [&](const auto &item) { return item.name == name; }; };
  const auto &bodies = study.bodies;
  if (r.kind == Kind::max_stress && std::none_of(bodies.begin(), bodies.end(), has_name(r.body)))
    throw document.error(key + ".body", "\"" + r.body + "\"", "the name of a [[body]]");
  const auto &pairs = study.contact_pairs;
  if (r.kind == Kind::contact_force && std::none_of(pairs.begin(), pairs.end(), has_name(r.pair)))
    throw document.error(key + ".pair", "\"" + r.pair + "\"", "the name of a [[contact_pair]]");
  if ((r.kind == Kind::volume || r.kind == Kind::pressure) && study.cavities.empty())
    throw document.error(key + ".kind", "a response of a cavity", "a block [[cavity]]");
}

void check_responses(const Study &study, const TomlDocument &document)
{
  std::set<std::string> names;
  for (std::size_t i = 0; i < study.responses.size(); ++i) {
    const solver::Response &r = study.responses[i];
    if (r.name.empty() || r.name.find_first_of(", \"\n") != std::string::npos || !names.insert(r.name).second)
      throw document.error(element("response", i), "a name that is empty, used before, or has blanks or commas",
                           "a name of its own");
    check_response(r, element("response", i), study, document);
  }
}

bool is_rigid(const Study &study, const std::string &name)
{
  return std::any_of(study.rigid_bodies.begin(), study.rigid_bodies.end(),
                     [&](const solver::RigidBody &body) { return body.name == name; });
}

void check_names(const Study &study, const geometry::Mesh &mesh, const TomlDocument &document)
{
  const MeshNames names(mesh, document);
  for (std::size_t i = 0; i < study.bodies.size(); ++i)
    names.check_body(study.bodies[i].name, element("body", i) + ".name");
  if (study.bodies.size() < mesh.bodies.size())
    throw document.error("body", "fewer bodies than the mesh has physical volumes", "a block [[body]] for each");
  for (std::size_t i = 0; i < study.supports.size(); ++i)
    names.check_place(study.supports[i], element("support", i));
  for (std::size_t i = 0; i < study.cavities.size(); ++i)
    names.check_surface(study.cavities[i].surface, element("cavity", i) + ".surface");
  for (std::size_t i = 0; i < study.loads.size(); ++i)
    names.check_place(study.loads[i], element("load", i));
  for (std::size_t i = 0; i < study.contact_pairs.size(); ++i) {
    for (const std::string &name : study.contact_pairs[i].secondary)
      names.check_surface(name, element("contact_pair", i) + ".secondary");
    const auto &primary = study.contact_pairs[i].primary;
    if (primary.size() == 1 && is_rigid(study, primary[0]))
      continue;
    for (const std::string &name : primary)
      names.check_surface(name, element("contact_pair", i) + ".primary");
  }
  for (std::size_t i = 0; i < study.responses.size(); ++i)
    names.check_place(study.responses[i], element("response", i), true);
}

/// Rigid bodies of a built-in actuator: their names become columns of history.csv.
void check_obstacles(const Study &study, const TomlDocument &document)
{
  std::set<std::string> names;
  for (std::size_t i = 0; i < study.rigid_bodies.size(); ++i) {
    const std::string &name = study.rigid_bodies[i].name;
    if (name.empty() || name.find_first_of(", \"\n") != std::string::npos || !names.insert(name).second)
      throw document.error(element("rigid", i), "a name that is empty, used before, or has blanks or commas",
                           "a name of its own");
    if (name == cage_pair || name.starts_with("balloon") || name.starts_with("backbone"))
      throw document.error(element("rigid", i) + ".name", "\"" + name + "\", which names a part of the actuator",
                           "a name of its own");
  }
}

std::string document_key(const std::string &key) { return key.starts_with("mesh.") ? key : "actuator." + key; }

/// The first pair of geometry parameters that contradict each other, placed at the one that stands in the file.
void report(const std::vector<geometry::Problem> &problems, const TomlDocument &document)
{
  if (problems.empty())
    return;
  const std::string a = document_key(problems.front().key_a);
  if (problems.front().key_b.empty())
    throw document.error(a, problems.front().message, "a value that can be built");
  const std::string b = document_key(problems.front().key_b);
  const bool a_given = static_cast<bool>(toml::at_path(document.root(), a));
  throw document.error(a_given ? a : b, problems.front().message,
                       "values of " + a + " and " + b + " that fit together");
}

} // namespace

void check_problem(const Study &study, const TomlDocument &document)
{
  const geometry::Mesh mesh = checked_mesh(study, document);
  check_bodies(study, document);
  check_names(study, mesh, document);
  check_loads(study, document);
  check_control(study, document);
  check_release(study, document);
  check_responses(study, document);
}

void check_actuator(const Study &study, const TomlDocument &document)
{
  check_material(study.actuator.balloon_material, "actuator.balloon_material", study, document);
  if (study.actuator.kind == ActuatorKind::balloon)
    return report(geometry::check(study.actuator.balloon.balloon), document);
  check_material(study.actuator.backbone_material, "actuator.backbone_material", study, document);
  if (study.method.model != ModelKind::fem)
    check_reduced(study, document); // before the checks of a mesh it needs not
  check_release(study, document);
  check_obstacles(study, document);
  if (!study.actuator.pebs.with_balloon && solver::drives_cavity(study.path.control))
    throw document.error("path.control", "a control that needs a balloon",
                         "load | release, or actuator.with_balloon = true");
  report(geometry::check(study.actuator.pebs, study.mesh), document);
}

} // namespace ballonet::studies
