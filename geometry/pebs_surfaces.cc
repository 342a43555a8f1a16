// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/pebs_surfaces.h"
#include "geometry/boundary.h"
#include <algorithm>
#include <map>

namespace ballonet::geometry
{

namespace
{

using Names = std::vector<std::string>;

Names balloon_names(Side side)
{
  switch (side) {
  case Side::inner:
    return {"balloon_inner"};
  case Side::outer:
    return {"balloon_outer"};
  case Side::lower:
    return {"balloon_base"};
  default:
    return {};
  }
}

Names rib_names(const CellTag &tag, Side side)
{
  Names names = {numbered("rib_", tag.index)};
  if (side == Side::inner)
    names.push_back(numbered("rib_inner_", tag.index));
  if (side == Side::inner && tag.land)
    names.emplace_back("wall");
  const bool towards_balloon = side == Side::inner || side == Side::lower || side == Side::upper;
  names.emplace_back(towards_balloon ? "backbone_contact" : "backbone_outside");
  return names;
}

/// All surfaces a free face belongs to.
Names names_of(const CellTag &tag, Side side)
{
  switch (tag.part) {
  case Part::balloon:
    return balloon_names(side);
  case Part::rib:
    return rib_names(tag, side);
  case Part::strip:
    return side == Side::inner ? Names{"wall", "backbone_contact"} : Names{"backbone_outside"};
  case Part::head:
    if (side == Side::lower)
      return {"head_contact", "backbone_contact"};
    return side == Side::upper ? Names{"head_top", "backbone_outside"} : Names{"backbone_outside"};
  case Part::base:
    if (side == Side::upper)
      return {"base_contact", "backbone_contact"};
    return side == Side::lower ? Names{"base_bottom"} : Names{"backbone_outside"};
  }
  return {};
}

bool in_symmetry_plane(const Mesh &mesh, const Face &face)
{
  const auto nodes = nodes_of(mesh, face);
  return std::all_of(nodes.begin(), nodes.end(), [&](std::uint32_t node) { return mesh.nodes[node][1] == 0; });
}

} // namespace

std::string numbered(const std::string &stem, int index)
{
  const std::string number = std::to_string(index + 1);
  return stem + (number.size() < 2 ? "0" : "") + number;
}

std::vector<Surface> name_surfaces(const TaggedMesh &tagged, bool half)
{
  std::map<std::string, std::vector<Face>> faces;
  for (const Face &face : free_faces(tagged.mesh)) {
    const CellTag &tag = tagged.tags[face.cell];
    if (half && in_symmetry_plane(tagged.mesh, face))
      faces["symmetry"].push_back(face);
    else
      for (const std::string &name : names_of(tag, tag.sides[face.local]))
        faces[name].push_back(face);
  }
  std::vector<Surface> surfaces;
  for (auto &[name, list] : faces)
    surfaces.push_back({name, std::move(list)});
  return surfaces;
}

} // namespace ballonet::geometry
