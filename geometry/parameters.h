// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

/// The parametric actuators as plain structs. Lengths in mm, angles in deg. Axis z points up, z = 0 is the top of the
/// base disc, the back wall lies on the -x side and y = 0 is the mirror plane of the default design.
/// Each struct lists its fields once, in fields(); reading, writing and describing a study all visit that list.
namespace ballonet::geometry
{

/// A rubber tube clamped at z = 0, closed at the top by a hemispherical dome of the same wall thickness.
struct Balloon {
  double diameter = 7.2; // outer
  double length = 90;    // from the base plane to the outside of the dome
  double wall = 0.5;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("diameter", self.diameter, "mm", 0.1, 1000, "outer diameter");
    v.quantity("length", self.length, "mm", 0.1, 10000, "from the base plane to the outside of the domed tip");
    v.quantity("wall", self.wall, "mm", 0.01, 100, "wall thickness");
  }
};

/// Rings around the balloon, numbered from the bottom. A list holds one value for all ribs or one per rib.
struct Ribs {
  int count = 20;
  double width = 2.0; // axial
  double gap = 2.8;   // axial, below each rib
  double thickness = 1.5;
  double inner_radius = 8.0;
  std::vector<double> position, slope, v_angle, arc, orientation;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.count("count", self.count, 1, 200, "number of ribs; the top one carries the head");
    v.quantity("width", self.width, "mm", 0.05, 100, "axial width of a rib");
    v.quantity("gap", self.gap, "mm", 0.05, 100, "axial gap below each rib; not used where position is given");
    v.quantity("thickness", self.thickness, "mm", 0.05, 100, "radial thickness of a rib");
    v.quantity("inner_radius", self.inner_radius, "mm", 0.1, 1000, "inner radius of the cage");
    v.quantities("position", self.position, "mm", 0, 10000,
                 "height of each rib's centre, rising; empty: count equal pitches of gap + width");
    v.quantities("slope", self.slope, "deg", -75, 75,
                 "tilt of each rib's plane about its diameter through the back wall; the top rib stays level");
    v.quantities("v_angle", self.v_angle, "deg", -75, 75,
                 "rise of both arms of each rib from the back wall to the front; the top rib stays level");
    v.quantities("arc", self.arc, "deg", 30, 360, "angle each rib covers, centred on its wall land; 360 deg: closed");
    v.quantities("orientation", self.orientation, "deg", -720, 720,
                 "direction of each rib's wall land about the axis, from the back (-x) towards +y");
  }
};

/// The back wall: one strip per gap, bent outwards into a corrugation, and the lands that close the ribs.
struct Wall {
  double thickness = 0.9; // trimmed: the bare backbone droops by 40 deg
  double width = 8.3;
  std::vector<double> rise = {1.4};
  double valley_share = 0.4;
  bool thick_land = false;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("thickness", self.thickness, "mm", 0.02, 100, "wall thickness, outwards from the ribs' inner radius");
    v.quantity("width", self.width, "mm", 0.05, 1000, "width of the wall, as an arc on its middle surface");
    v.quantities(
        "rise", self.rise, "mm", 0, 100,
        "height of the corrugation's crest over the wall; one value, or one per gap from the bottom; 0 mm: plain");
    v.quantity("valley_share", self.valley_share, "1", 0.1, 0.9,
               "valley radius over the sum of valley and crest radius of the corrugation's middle line");
    v.flag("thick_land", self.thick_land, "the lands that close the ribs have the ribs' thickness, not the wall's");
  }
};

struct Head {
  double thickness = 2.0;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("thickness", self.thickness, "mm", 0.05, 100, "thickness of the head disc, which sits on the top rib");
  }
};

struct Base {
  double thickness = 4.0;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("thickness", self.thickness, "mm", 0.05, 100, "thickness of the base disc, which carries the wall");
  }
};

/// A balloon in a ribbed backbone (PEBS). The discs have the outer diameter of the ribs.
struct Pebs {
  Balloon balloon;
  Ribs ribs;
  Wall wall;
  Head head;
  Base base;
  bool with_balloon = true;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.group("balloon", self.balloon, "the balloon");
    v.group("ribs", self.ribs, "the ribs of the backbone");
    v.group("wall", self.wall, "the corrugated back wall");
    v.group("head", self.head, "the head disc");
    v.group("base", self.base, "the base disc");
    v.flag("with_balloon", self.with_balloon, "false: the backbone alone");
  }
};

/// Only the balloon (actuator kind "balloon").
struct BalloonAlone {
  Balloon balloon;
  double pitch = 4.8;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.group("balloon", self.balloon, "the balloon");
    v.quantity("pitch", self.pitch, "mm", 0.01, 1000, "length the mesh size balloon_per_pitch refers to");
  }
};

/// Numbers of elements. Counts around are for 360 deg, also when only half is meshed.
struct MeshSizes {
  bool symmetry = true;
  int along_fold = 10, across_wall = 4, through_wall = 1;
  int around_ring = 24, through_rib = 1, along_rib = 1;
  int through_head = 1, through_base = 1, disc_rings = 1;
  int balloon_per_pitch = 4, balloon_around = 16, balloon_through = 1, dome_rings = 2;
  double smallest_jacobian = 0.1;
  double largest_aspect = 15;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.flag("symmetry", self.symmetry, "mesh only the half y >= 0 (for mirror-symmetric designs)");
    v.count("along_fold", self.along_fold, 2, 200,
            "elements along a corrugation of mean length, even; the others in proportion");
    v.count("across_wall", self.across_wall, 2, 100, "elements across the width of the wall; even");
    v.count("through_wall", self.through_wall, 1, 20, "elements through the wall");
    v.count("around_ring", self.around_ring, 8, 800, "elements around a rib ring (360 deg); a multiple of 8");
    v.count("through_rib", self.through_rib, 1, 20, "radial elements of a rib outside the wall's thickness");
    v.count("along_rib", self.along_rib, 1, 20, "axial elements of a rib");
    v.count("through_head", self.through_head, 1, 20, "elements through the head disc");
    v.count("through_base", self.through_base, 1, 20, "elements through the base disc");
    v.count("disc_rings", self.disc_rings, 1, 20, "rings of elements around the core of a disc");
    v.count("balloon_per_pitch", self.balloon_per_pitch, 1, 50, "elements along the balloon per mean rib pitch");
    v.count("balloon_around", self.balloon_around, 8, 400, "elements around the balloon (360 deg); a multiple of 8");
    v.count("balloon_through", self.balloon_through, 1, 10, "elements through the balloon wall");
    v.count("dome_rings", self.dome_rings, 1, 20, "rings of elements around the core of the domed tip");
    v.quantity("smallest_jacobian", self.smallest_jacobian, "1", 0, 1,
               "a mesh with a cell whose smallest over largest Jacobian lies below this is rejected");
    v.quantity("largest_aspect", self.largest_aspect, "1", 1, 1e6,
               "a mesh with a cell whose longest over shortest mean edge lies above this is rejected");
  }
};

} // namespace ballonet::geometry
