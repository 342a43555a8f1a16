// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Everything the solver can be asked for, as plain structs with defaults. Units inside: N, mm, MPa, s, t (tonne).
/// Each struct lists its fields once, in fields(); reading, writing and describing a study all visit that list.
namespace ballonet::solver
{

using Vector3 = std::array<double, 3>;
constexpr double infinity = std::numeric_limits<double>::infinity();

enum class Law { neo_hookean, saint_venant };

struct Material {
  std::string name;
  Law law = Law::neo_hookean;
  std::optional<double> c10, d1, youngs_modulus, poisson_ratio;
  double density = 0;         // t/mm^3
  double relaxation_time = 0; // s
  double mass_damping = 0;    // 1/s

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.choice("law", self.law, {{"neo_hookean", Law::neo_hookean}, {"saint_venant", Law::saint_venant}},
             "constitutive law");
    v.quantity("c10", self.c10, "MPa", 0, 1e6, "neo-Hookean coefficient of W = C10 (I1bar - 3) + (J - 1)^2 / D1");
    v.quantity("d1", self.d1, "1/MPa", 0, 1e6, "compressibility of the same law; bulk modulus K = 2 / D1");
    v.quantity("youngs_modulus", self.youngs_modulus, "MPa", 0, 1e9,
               "saint_venant, or neo_hookean by small-strain moduli");
    v.quantity("poisson_ratio", self.poisson_ratio, "1", -0.999, 0.49999, "goes with youngs_modulus");
    v.quantity("density", self.density, "t/mm^3", 0, 1e-6, "mass per reference volume");
    v.quantity("relaxation_time", self.relaxation_time, "s", 0, 10,
               "Kelvin-Voigt viscosity: viscous stress = 2 mu * relaxation_time * strain rate");
    v.quantity("mass_damping", self.mass_damping, "1/s", 0, 1e6,
               "Rayleigh's alpha: force against the velocity of every particle = mass_damping * mass * velocity; acts "
               "where the path runs with inertia");
  }
};

struct Body {
  std::string name, material;
  bool mixed = false; // Q2/P-1 with element pressures
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("name", self.name, "physical volume of the mesh");
    v.text("material", self.material, "name of a [material.X] block");
    v.flag("mixed", self.mixed, "element pressures as unknowns (Q2/P-1), for nearly incompressible materials");
  }
};

struct Support {
  std::string surface;
  std::vector<std::string> fix;                   // of "x", "y", "z"
  std::array<std::optional<double>, 3> move = {}; // displacement at load factor 1
  std::string nodes = {};                         // instead of the surface
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("surface", self.surface, "surface that is held");
    v.text("nodes", self.nodes, "or the set of nodes that is held: a physical curve or point of the mesh");
    v.words("fix", self.fix, {"x", "y", "z"}, "directions held at rest");
    v.vector("move", self.move, "mm", "displacement reached at load factor 1, by direction: {x = \"4 mm\"}");
  }
};

struct Cavity {
  std::string surface;
  Vector3 origin = {0, 0, 0};
  std::vector<std::string> directions = {"x", "y", "z"};
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("surface", self.surface, "wetted surface; closed by symmetry planes and supports");
    v.point("origin", self.origin, "mm", "a point common to all planes that close the cavity");
    v.words("directions", self.directions, {"x", "y", "z"},
            "directions in which the enclosed volume is measured; leave out one when two parallel planes close it");
  }
};

struct Load {
  std::string surface;
  Vector3 traction = {0, 0, 0}; // dead, per reference area
  double pressure = 0;          // follower
  std::string nodes = {};       // instead of the surface
  Vector3 force = {0, 0, 0};    // N, dead, on the whole set of nodes
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("surface", self.surface, "surface that carries the load");
    v.point("traction", self.traction, "MPa", "dead load per reference area at load factor 1");
    v.quantity("pressure", self.pressure, "MPa", -1e3, 1e3,
               "follower pressure at load factor 1, positive into the body");
    v.text("nodes", self.nodes, "or the set of nodes that carries a force: a physical curve or point of the mesh");
    v.point("force", self.force, "N", "dead force at load factor 1 on the set, the same share on each of its nodes");
  }
};

/// How contact pairs keep their surfaces apart.
enum class Enforcement { penalty, augmented_lagrangian };

/// The keys of augmented contact, the same for all who have contact pairs.
template <class Self, class Visitor>
void augmentation_fields(Self &self, Visitor &v)
{
  v.choice(
      "enforcement", self.enforcement,
      {{"penalty", Enforcement::penalty}, {"augmented_lagrangian", Enforcement::augmented_lagrangian}},
      "penalty: surfaces penetrate by what the pressure takes; augmented_lagrangian: the penetration left by a step "
      "is taken back at the start of the next one, with the pressure kept, and steps that leave more than the "
      "tolerance are solved again");
  v.quantity("augmentation_tolerance", self.augmentation_tolerance, "mm", 1e-6, 10,
             "largest penetration that augmented_lagrangian leaves, in the mean around a corner of the faces");
  v.count("max_augmentations", self.max_augmentations, 0, 1000,
          "how often augmented_lagrangian solves a step again; what is left then is column mean_penetration_mm and in "
          "the log. 0: never");
}

struct ContactPair {
  std::string name;
  std::vector<std::string> secondary, primary;
  double friction = 0.3, thickness = 0.35, stiffness = 15, onset = 0.06, penetration_limit = 0.15;
  double elastic_slip = 0.03;         // mm
  double viscous_velocity = infinity; // mm/s
  int points_per_side = 5, passes = 2;
  double point_spacing = 0; // mm
  Enforcement enforcement = Enforcement::penalty;
  double augmentation_tolerance = 0.01; // mm
  int max_augmentations = 10;
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("name", self.name, "how the pair is called in results");
    v.names("secondary", self.secondary, "surfaces that keep out of the primary ones; their quadrature points feel it");
    v.names("primary", self.primary,
            "surfaces that are moved back by the thickness; with two passes they feel it too. Or one rigid body");
    v.quantity("friction", self.friction, "1", 0, 10, "Coulomb coefficient");
    v.quantity("thickness", self.thickness, "mm", 0, 10,
               "how far the primary surface is moved back into its body; rounds its edges by the same radius");
    v.quantity("stiffness", self.stiffness, "MPa/mm", 0, 1e6, "contact pressure per penetration");
    v.quantity("onset", self.onset, "mm", 0, 1, "penetration over which the stiffness grows from zero");
    v.quantity("elastic_slip", self.elastic_slip, "mm", 1e-9, 10,
               "how far the surfaces give before they slide: friction builds up over it and is kept from step to step");
    v.quantity("viscous_velocity", self.viscous_velocity, "mm/s", 1e-6, 1e9,
               "sliding speed at which friction has doubled; without it friction does not depend on the speed");
    v.count(
        "points_per_side", self.points_per_side, 2, 20,
        "contact points per side of a secondary face; their distance must stay below the thickness as it stretches");
    v.count(
        "passes", self.passes, 1, 2,
        "2: points of the primary surface, edges and corners included, feel the secondary one too, half the area each");
    v.quantity("point_spacing", self.point_spacing, "mm", 0, 1e3,
               "largest distance at rest of the points of a primary surface; 0 mm: half the thickness");
    v.quantity("penetration_limit", self.penetration_limit, "mm", 0, 10, "a step that ends deeper is rejected");
    augmentation_fields(self, v);
  }
};

enum class RigidShapeKind { plane, cylinder, box, ellipsoid };

/// A rigid body in closed form, fixed in space: what deformable bodies are pressed against.
struct RigidBody {
  std::string name;
  RigidShapeKind shape = RigidShapeKind::plane;
  Vector3 point = {0, 0, 0}, axis = {0, 0, 1}, half_lengths = {1, 1, 1};
  double radius = 1;
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("name", self.name, "how contact pairs call it as their primary side; column NAME_force_N of a pebs");
    v.choice("shape", self.shape,
             {{"plane", RigidShapeKind::plane},
              {"cylinder", RigidShapeKind::cylinder},
              {"box", RigidShapeKind::box},
              {"ellipsoid", RigidShapeKind::ellipsoid}},
             "plane: all below it is solid; cylinder: without ends; box and ellipsoid: along x, y, z");
    v.point("point", self.point, "mm", "a point of the plane or of the cylinder's axis, or the centre");
    v.point("axis", self.axis, "1", "plane: direction out of the solid; cylinder: its axis");
    v.point("half_lengths", self.half_lengths, "mm",
            "box: half its sides; ellipsoid: its half axes, a sphere's are equal");
    v.quantity("radius", self.radius, "mm", 0, 1e6, "of the cylinder");
  }
};

enum class ResponseKind { displacement, position, reaction, contact_force, volume, pressure, max_stress };

struct Response {
  std::string name;
  ResponseKind kind = ResponseKind::displacement;
  std::string surface;          // displacement, position: mean over it; reaction: sum over it
  std::optional<Vector3> point; // displacement, position of the nearest node
  std::string component = "x";  // x y z magnitude
  std::string body;             // max_stress
  std::string pair;             // contact_force
  std::string nodes = {};       // instead of the surface
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("name", self.name, "column of history.csv and name for objectives");
    v.choice("kind", self.kind,
             {{"displacement", ResponseKind::displacement},
              {"position", ResponseKind::position},
              {"reaction", ResponseKind::reaction},
              {"contact_force", ResponseKind::contact_force},
              {"volume", ResponseKind::volume},
              {"pressure", ResponseKind::pressure},
              {"max_stress", ResponseKind::max_stress}},
             "what is measured");
    v.text("surface", self.surface, "where: mean over the surface (sum for reaction)");
    v.text("nodes", self.nodes, "where: mean over the set of nodes (sum for reaction)");
    v.point("point", self.point, "mm", "where: the node nearest to this reference point");
    v.text("component", self.component, "x, y, z or magnitude");
    v.text("body", self.body, "body of max_stress");
    v.text("pair", self.pair, "contact pair of contact_force");
  }
};

enum class Control { volume, pressure, ramp, load, release, arc_length };
/// Whether the control drives the volume or the pressure of a cavity.
/// Whether only a cavity can be driven so.
constexpr bool drives_cavity(Control control)
{
  return control == Control::volume || control == Control::pressure || control == Control::ramp;
}

/// When steps under control of volume or pressure feel viscosity, mass and the speed of sliding.
enum class Rates { where_needed, always };
enum class CriticalPoints { none, locate };
enum class Integrator { by_control, backward_euler, generalised_alpha };

/// How the path is driven. Load factor: 0 to 1 over the run under `load`; under the other controls it brings gravity,
/// loads and moved supports in during the first stretch, before the cavity is driven; under `release` it is 1 from the
/// first instant.
struct Path {
  Control control = Control::volume;
  double volume_rate = 6;         // V0 per second
  double volume_max = infinity;   // V / V0
  double pressure_rate = 0.08;    // MPa / s
  double pressure_max = infinity; // MPa
  double initial_pressure = 0;    // MPa, reached together with the full load factor
  double preload_time = 10;       // s: long against every relaxation time, so the preload is quasi-static
  int preload_steps = 1;
  int load_steps = 10;
  Rates rates = Rates::where_needed;
  int rest_every = 3; // steps in motion
  bool inertia = true;
  CriticalPoints critical_points = CriticalPoints::none;
  double critical_tolerance = 0.02;
  double branch_amplitude = 0; // mm
  Integrator integrator = Integrator::by_control;
  double spectral_radius = 0.8;
  double duration = 1;                                          // s
  double step_initial = 2e-3, step_min = 1e-5, step_max = 4e-2; // s
  double arc_step_max = infinity;                               // mm
  int max_steps = 1000;
  int max_setbacks = 24;
  double time_limit = infinity; // s of wall time
  int checkpoint_every = 10;    // steps
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.choice(
        "control", self.control,
        {{"volume", Control::volume},
         {"pressure", Control::pressure},
         {"ramp", Control::ramp},
         {"load", Control::load},
         {"release", Control::release},
         {"arc_length", Control::arc_length}},
        "what is prescribed: cavity volume, cavity pressure (quasi-static), pressure ramp in time (with inertia), "
        "load factor (no cavity), length along the path through its limit points (quasi-static; the cavity's "
        "pressure or, without one, the load factor follows; for bodies without contact), or nothing: free motion in "
        "time after a body at rest is let go under gravity, loads and initial_pressure");
    v.quantity("volume_rate", self.volume_rate, "1/s", 1e-6, 1e6, "growth of V / V0 per second of pseudo-time");
    v.quantity("volume_max", self.volume_max, "1", 1, 1e6, "the path ends at this V / V0");
    v.quantity("pressure_rate", self.pressure_rate, "MPa/s", 1e-9, 1e6,
               "growth of the pressure under pressure and ramp");
    v.quantity("pressure_max", self.pressure_max, "MPa", 0, 1e6,
               "the path ends when the running maximum of the pressure passes this");
    v.quantity("initial_pressure", self.initial_pressure, "MPa", 0, 1e3, "reached together with the preload");
    v.quantity("preload_time", self.preload_time, "s", 1e-6, 1e9, "pseudo-time over which gravity comes in");
    v.count("preload_steps", self.preload_steps, 1, 1000, "first guess of the number of preload steps");
    v.count("load_steps", self.load_steps, 1, 100000, "first guess of the number of steps under load control");
    v.choice("rates", self.rates, {{"where_needed", Rates::where_needed}, {"always", Rates::always}},
             "under volume and pressure: where_needed takes static steps from equilibrium to equilibrium, and steps "
             "regularised by rate (viscosity, mass, speed of sliding) where no static step is found, until the body "
             "comes to rest at held volume or pressure; always never looks for equilibrium");
    v.count("rest_every", self.rest_every, 1, 1000000,
            "steps in motion between two searches for rest (rates = where_needed)");
    v.flag("inertia", self.inertia, "with mass (lumped); without, the path is driven by viscosity alone");
    v.choice("critical_points", self.critical_points,
             {{"none", CriticalPoints::none}, {"locate", CriticalPoints::locate}},
             "locate: limit points and bifurcations between two equilibria are located by bisection and written with "
             "their modes; each costs about 30 factorisations");
    v.quantity("critical_tolerance", self.critical_tolerance, "1", 1e-6, 0.1,
               "how closely a critical point is bracketed: part of the step in which it lies");
    v.quantity("branch_amplitude", self.branch_amplitude, "mm", 0, 1e3,
               "at a located bifurcation the path goes on with its mode added: the node that moves most moves by this; "
               "0: it stays on its branch");
    v.choice("integrator", self.integrator,
             {{"by_control", Integrator::by_control},
              {"backward_euler", Integrator::backward_euler},
              {"generalised_alpha", Integrator::generalised_alpha}},
             "how time is stepped where there is inertia: backward Euler (first order, damps all motion), the "
             "generalised-alpha method of Wood, Bossak and Zienkiewicz (second order), or by_control: the latter under "
             "release, else the former");
    v.quantity("spectral_radius", self.spectral_radius, "1", 0, 1,
               "generalised_alpha: what is left of the highest frequencies after a step; 1 damps nothing");
    v.quantity("duration", self.duration, "s", 1e-9, 1e9, "the path ends at this time under release");
    v.quantity("step_initial", self.step_initial, "s", 1e-9, 1e3, "first time step after the preload");
    v.quantity("step_min", self.step_min, "s", 1e-12, 1e3, "smallest time step; below it the path has diverged");
    v.quantity("step_max", self.step_max, "s", 1e-9, 1e9, "largest time step");
    v.quantity("arc_step_max", self.arc_step_max, "mm", 1e-9, 1e9,
               "largest step under arc_length: root mean square of the nodes' displacements in it");
    v.count("max_steps", self.max_steps, 1, 1000000, "the path ends after so many steps");
    v.count("max_setbacks", self.max_setbacks, 1, 1000000,
            "the path has come to a standstill when twice the rejected attempts exceed the steps by more than this");
    v.quantity("time_limit", self.time_limit, "s", 0, 1e9, "wall time after which the path ends");
    v.count("checkpoint_every", self.checkpoint_every, 1, 1000000, "steps between checkpoints");
  }
};

struct Newton {
  double tolerance = 1e-8;
  double force_floor = 0.5; // N
  double krylov_below = 0.1, reuse_below = 1e-3;
  int max_iterations = 25;
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("tolerance", self.tolerance, "1", 1e-14, 1e-2,
               "residual norm relative to the norm of the applied forces");
    v.quantity("force_floor", self.force_floor, "N", 0, 1e9, "smallest force scale the residual is compared with");
    v.quantity("krylov_below", self.krylov_below, "1", 0, 1,
               "below this residual GMRES solves with the new tangent and the last factor as preconditioner; 0: never");
    v.quantity("reuse_below", self.reuse_below, "1", 0, 1,
               "below this residual the last factor serves again as long as the residual falls tenfold; 0: never");
    v.count("max_iterations", self.max_iterations, 1, 1000, "iterations before a step is cut");
  }
};

/// One simulation.
struct Parameters {
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<Support> supports;
  std::optional<Cavity> cavity;
  std::vector<Load> loads;
  std::vector<ContactPair> contact_pairs;
  std::vector<RigidBody> rigid_bodies;
  std::vector<Response> responses;
  Vector3 gravity = {0, 0, 0}; // mm/s^2
  Path path;
  Newton newton;
};

} // namespace ballonet::solver
