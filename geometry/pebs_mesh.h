// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include "geometry/mesh_failure.h"
#include "geometry/parameters.h"
#include <variant>

namespace ballonet::geometry
{

/// A rib in the mesh: where it is and which nodes it has.
struct RibLayout {
  double centre_z = 0;              ///< mm, of the land
  std::vector<std::uint32_t> nodes; ///< of the whole ring, land included
  std::vector<std::uint32_t> land;  ///< of the wall land only
};

/// A node of the balloon's outer surface.
struct BalloonNode {
  std::uint32_t node = 0;
  double z = 0, angle = 0; ///< mm; rad about the axis from the back (-x) towards +y
};

/// What a judge of the deformed actuator needs to know about the mesh.
struct PebsLayout {
  double inner_radius = 0, rib_thickness = 0, rib_width = 0; ///< mm: Ri, t_r, b
  double pitch = 0, height = 0;                              ///< mm: mean rib pitch; base plane to head
  double balloon_radius = 0, balloon_length = 0;             ///< mm: outer radius, length (0 without a balloon)
  std::vector<RibLayout> ribs;                               ///< from the bottom
  std::vector<std::uint32_t> head;                           ///< all nodes of the head disc
  std::vector<BalloonNode> balloon_outer;
  std::vector<std::uint32_t> balloon_tip; ///< the outer nodes of the dome
};

struct PebsMesh {
  Mesh mesh;
  PebsLayout layout;
};

/// The mesh of an actuator, or the reason why there is none: parameters that contradict each other, or a mesh of too
/// low quality. Bodies: "balloon", "backbone". Surfaces: balloon_inner, balloon_outer, balloon_base, base_bottom,
/// base_contact, head_contact, head_top, wall, rib_01 ..., rib_inner_01 ..., backbone_contact, backbone_outside,
/// symmetry (half model).
std::variant<PebsMesh, MeshFailure> build_mesh(const Pebs &pebs, const MeshSizes &sizes);
std::variant<PebsMesh, MeshFailure> build_mesh(const BalloonAlone &alone, const MeshSizes &sizes);

} // namespace ballonet::geometry
