// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/pebs_mesh.h"
#include "geometry/backbone.h"
#include "geometry/balloon.h"
#include "geometry/boundary.h"
#include "geometry/parameter_check.h"
#include "geometry/pebs_surfaces.h"
#include "geometry/quality.h"
#include "geometry/rib_pattern.h"
#include <algorithm>
#include <cmath>

namespace ballonet::geometry
{

namespace
{

using Nodes = std::vector<std::uint32_t>;

void sort_unique(Nodes &nodes)
{
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

void collect_parts(PebsLayout &layout, const TaggedMesh &tagged)
{
  for (std::size_t i = 0; i < tagged.tags.size(); ++i) {
    const auto &cell = tagged.mesh.cells[i];
    const CellTag &tag = tagged.tags[i];
    const auto append = [&](Nodes &nodes) { nodes.insert(nodes.end(), cell.begin(), cell.end()); };
    if (tag.part == Part::head)
      append(layout.head);
    if (tag.part != Part::rib)
      continue;
    RibLayout &rib = layout.ribs[static_cast<std::size_t>(tag.index)];
    append(rib.nodes);
    if (tag.land)
      append(rib.land);
  }
  sort_unique(layout.head);
  for (RibLayout &rib : layout.ribs) {
    sort_unique(rib.nodes);
    sort_unique(rib.land);
  }
}

void collect_balloon(PebsLayout &layout, const Mesh &mesh, const Balloon &balloon)
{
  layout.balloon_radius = balloon.diameter / 2;
  layout.balloon_length = balloon.length;
  Nodes outer;
  if (const Surface *surface = find_surface(mesh, "balloon_outer"))
    for (const Face &face : surface->faces)
      for (const std::uint32_t node : nodes_of(mesh, face))
        outer.push_back(node);
  sort_unique(outer);
  for (const std::uint32_t node : outer) {
    const Point &p = mesh.nodes[node];
    layout.balloon_outer.push_back({node, p[2], std::atan2(p[1], -p[0])});
    if (p[2] > balloon.length - layout.balloon_radius + 1e-6)
      layout.balloon_tip.push_back(node);
  }
}

PebsLayout make_layout(const TaggedMesh &tagged, const Pebs &pebs)
{
  const RibPattern pattern(pebs.ribs, pebs.wall);
  PebsLayout layout;
  layout.inner_radius = pebs.ribs.inner_radius;
  layout.rib_thickness = pebs.ribs.thickness;
  layout.rib_width = pebs.ribs.width;
  layout.height = pattern.height();
  layout.pitch = layout.height / pattern.count();
  layout.ribs.resize(static_cast<std::size_t>(pattern.count()));
  for (int rib = 0; rib < pattern.count(); ++rib)
    layout.ribs[static_cast<std::size_t>(rib)].centre_z = pattern.centre(rib);
  collect_parts(layout, tagged);
  if (pebs.with_balloon)
    collect_balloon(layout, tagged.mesh, pebs.balloon);
  return layout;
}

/// Measures the quality; the reason if the mesh is rejected.
std::optional<std::string> judge(Mesh &mesh, const MeshSizes &sizes)
{
  mesh.quality = measure_quality(mesh);
  return rejection(mesh, mesh.quality, {sizes.smallest_jacobian, sizes.largest_aspect});
}

MeshFailure contradiction(std::vector<Problem> problems) { return {problems.front().message, std::move(problems)}; }

} // namespace

std::variant<PebsMesh, MeshFailure> build_mesh(const Pebs &pebs, const MeshSizes &sizes)
{
  if (auto problems = check(pebs, sizes); !problems.empty())
    return contradiction(std::move(problems));
  BlockMesh blocks;
  add_backbone(blocks, pebs, sizes);
  if (pebs.with_balloon)
    add_balloon(blocks, pebs.balloon, sizes, RibPattern(pebs.ribs, pebs.wall).height() / pebs.ribs.count);
  TaggedMesh tagged = std::move(blocks).finish(sizes.symmetry);
  tagged.mesh.surfaces = name_surfaces(tagged, sizes.symmetry);
  if (auto reason = judge(tagged.mesh, sizes))
    return MeshFailure{*reason, {}};
  PebsLayout layout = make_layout(tagged, pebs);
  return PebsMesh{std::move(tagged.mesh), std::move(layout)};
}

std::variant<PebsMesh, MeshFailure> build_mesh(const BalloonAlone &alone, const MeshSizes &sizes)
{
  auto problems = check(alone.balloon);
  for (Problem &problem : check(sizes))
    problems.push_back(std::move(problem));
  if (!problems.empty())
    return contradiction(std::move(problems));
  BlockMesh blocks;
  add_balloon(blocks, alone.balloon, sizes, alone.pitch);
  TaggedMesh tagged = std::move(blocks).finish(sizes.symmetry);
  tagged.mesh.surfaces = name_surfaces(tagged, sizes.symmetry);
  if (auto reason = judge(tagged.mesh, sizes))
    return MeshFailure{*reason, {}};
  PebsLayout layout;
  collect_balloon(layout, tagged.mesh, alone.balloon);
  return PebsMesh{std::move(tagged.mesh), std::move(layout)};
}

} // namespace ballonet::geometry
