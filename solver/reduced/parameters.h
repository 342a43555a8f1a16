// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <numbers>
#include <optional>

/// What the reduced model of a balloon in a ribbed backbone needs to know, as plain structs with defaults.
/// Units: N, mm, MPa, s, t (tonne), rad. Each struct lists its fields once, in fields().
namespace ballonet::solver::reduced
{

/// A neo-Hookean tube, W = C10 (I1 - 3), incompressible.
struct Balloon {
  double diameter = 7.2;    // outer
  double wall = 0.5;        // thickness
  double length = 90;       // at rest
  double c10 = 0.16;        // MPa
  double density = 1.08e-9; // t/mm^3

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("diameter", self.diameter, "mm", 0.1, 1000, "outer diameter");
    v.quantity("wall", self.wall, "mm", 0.01, 100, "wall thickness");
    v.quantity("length", self.length, "mm", 0.1, 10000, "length at rest");
    v.quantity("c10", self.c10, "MPa", 1e-6, 1e6, "neo-Hookean coefficient of W = C10 (I1 - 3)");
    v.quantity("density", self.density, "t/mm^3", 0, 1e-6, "mass per volume");
  }
};

/// Closed rings around the balloon, one above each gap.
struct Ribs {
  int count = 20;
  double width = 2.0; // axial
  double gap = 2.8;   // axial, below each rib
  double thickness = 1.5;
  double inner_radius = 8.0;
  std::optional<double> mass; // of one rib

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.count("count", self.count, 2, 200, "number of ribs; the top one carries the head");
    v.quantity("width", self.width, "mm", 0.05, 100, "axial width of a rib");
    v.quantity("gap", self.gap, "mm", 0.05, 100, "axial gap below each rib");
    v.quantity("thickness", self.thickness, "mm", 0.05, 100, "radial thickness of a rib");
    v.quantity("inner_radius", self.inner_radius, "mm", 0.1, 1000, "inner radius of the cage");
    v.quantity("mass", self.mass, "t", 0, 1, "mass of one rib; from its volume if absent");
  }
};

/// The back wall: one corrugation per gap, whose middle line is half an ellipse over the gap.
struct Wall {
  double thickness = 0.8;
  double width = 8.3;          // arc on the middle surface
  double rise = 1.4;           // 0: flat
  bool curved = true;          // follows the cylinder
  double youngs_modulus = 180; // MPa, of the whole backbone
  double poisson_ratio = 0.45; // likewise
  double density = 1.4e-9;     // t/mm^3, likewise

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("thickness", self.thickness, "mm", 0.02, 100, "wall thickness, outwards from the ribs' inner radius");
    v.quantity("width", self.width, "mm", 0.05, 1000, "width of the wall, as an arc on its middle surface");
    v.quantity("rise", self.rise, "mm", 0, 100, "height of the corrugation's crest over the wall");
    v.flag("curved", self.curved, "the wall follows the cylinder; without, it is a flat strip (a softer hinge)");
    v.quantity("youngs_modulus", self.youngs_modulus, "MPa", 1e-3, 1e9, "of the backbone");
    v.quantity("poisson_ratio", self.poisson_ratio, "1", -0.99, 0.5, "of the backbone");
    v.quantity("density", self.density, "t/mm^3", 0, 1e-6, "of the backbone, mass per volume");
  }
};

/// The disc on the top rib; it has the outer radius of the ribs.
struct Head {
  double thickness = 2.0;
  std::optional<double> mass;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("thickness", self.thickness, "mm", 0.05, 100, "thickness of the head disc, which sits on the top rib");
    v.quantity("mass", self.mass, "t", 0, 1, "mass of the head; from its volume if absent");
  }
};

/// Static path: a row every angle_step until the geometric stop. The model has no closed form for the stop.
struct StaticPath {
  double angle_step = std::numbers::pi / 36; // rad
  double stop_angle = std::numbers::pi * 1.5;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("angle_step", self.angle_step, "rad", 1e-4, 1, "head angle between two rows");
    v.quantity("stop_angle", self.stop_angle, "rad", 0, 20, "head angle of the geometric stop, end of the path");
  }
};

/// Dynamic path: the pressure grows at a constant rate from the backbone's droop at rest.
struct Ramp {
  double pressure_rate = 0.08;                // MPa/s
  double duration = 0.8;                      // s
  double stop_angle = std::numbers::pi * 1.5; // rad
  double step = 1e-4;                         // s
  int steps_per_row = 10;                     //
  double mass_damping = 1.142;                // 1/s
  double hinge_damping = 4.51e-3;             // s
  double radial_mobility = 2e5;               // mm/(s MPa)

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("pressure_rate", self.pressure_rate, "MPa/s", 1e-9, 1e6, "growth of the pressure");
    v.quantity("duration", self.duration, "s", 1e-6, 1e6, "the path ends at this time");
    v.quantity("stop_angle", self.stop_angle, "rad", 0, 20, "or at this head angle");
    v.quantity("step", self.step, "s", 1e-9, 1, "time step");
    v.count("steps_per_row", self.steps_per_row, 1, 1000000, "time steps between two rows");
    v.quantity("mass_damping", self.mass_damping, "1/s", 0, 1e6, "damping forces per mass and velocity");
    v.quantity("hinge_damping", self.hinge_damping, "s", 0, 1e3, "damping moment of a hinge per its elastic stiffness");
    v.quantity("radial_mobility", self.radial_mobility, "mm/(s MPa)", 1e-6, 1e12,
               "radial velocity of the balloon per unbalanced pressure");
  }
};

/// One actuator.
struct Parameters {
  Balloon balloon;
  Ribs ribs;
  Wall wall;
  Head head;
  double gravity = 9810; // mm/s^2, against the upright actuator
  StaticPath static_path;
  Ramp ramp;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.group("balloon", self.balloon, "the balloon");
    v.group("ribs", self.ribs, "the ribs of the backbone");
    v.group("wall", self.wall, "the corrugated back wall");
    v.group("head", self.head, "the head disc");
    v.quantity("gravity", self.gravity, "mm/s^2", -1e6, 1e6, "downwards; the actuator stands upright");
    v.group("static_path", self.static_path, "the quasi-static path");
    v.group("ramp", self.ramp, "the dynamic path");
  }

  double pitch() const { return ribs.gap + ribs.width; }                     ///< mm
  double height() const { return ribs.count * pitch(); }                     ///< mm, from the base to the head
  double outer_radius() const { return ribs.inner_radius + ribs.thickness; } ///< mm
};

/// Throws std::invalid_argument naming the field whose value lies outside its range, or the two that do not fit: the
/// balloon's wall must be thinner than its radius, and the balloon must have room within the ribs.
void check(const Parameters &parameters);

} // namespace ballonet::solver::reduced
