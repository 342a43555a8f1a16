// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/parameters.h"
#include "optimize/problem.h"
#include "solver/parameters.h"
#include "studies/judge.h"
#include "studies/method.h"
#include <optional>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// The block [study].
struct Title {
  std::string name, question;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("name", self.name, "short name of the study, shown in reports");
    v.text("question", self.question, "what the study is to answer");
  }
};

enum class ActuatorKind { pebs, pba, gripper, balloon, mesh };

/// The block [actuator]: what is inflated.
struct Actuator {
  ActuatorKind kind = ActuatorKind::pebs;
  std::string balloon_material = "latex", backbone_material = "tpu";
  bool head_held = false;
  geometry::Pebs pebs;
  geometry::BalloonAlone balloon;
  std::string file; // kind mesh

  /// The field that decides which others there are.
  template <class Self, class Visitor>
  static void kind_field(Self &self, Visitor &v)
  {
    v.choice("kind", self.kind,
             {{"pebs", ActuatorKind::pebs},
              {"pba", ActuatorKind::pba},
              {"gripper", ActuatorKind::gripper},
              {"balloon", ActuatorKind::balloon},
              {"mesh", ActuatorKind::mesh}},
             "family of the actuator; mesh: any hexahedral mesh, with the problem written in the study");
  }

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    kind_field(self, v);
    if (self.kind == ActuatorKind::mesh)
      v.text("file", self.file, "gmsh file of 27-node hexahedra, relative to the study file");
    if (self.kind == ActuatorKind::pebs || self.kind == ActuatorKind::balloon)
      v.text("balloon_material", self.balloon_material, "name of a [material.X] block, or built in: latex");
    if (self.kind == ActuatorKind::pebs) {
      v.text("backbone_material", self.backbone_material, "name of a [material.X] block, or built in: tpu");
      v.flag("head_held", self.head_held, "the head disc is held where it is: tip_force_N is the blocked force");
      geometry::Pebs::fields(self.pebs, v);
    }
    if (self.kind == ActuatorKind::balloon)
      geometry::BalloonAlone::fields(self.balloon, v);
  }
};

/// The block [contact]: the contact pairs of the built-in actuators.
struct ContactDefaults {
  double friction = 0.3, stiffness = 15, thickness = 0.35, onset = 0.06, penetration_limit = 0.15;
  double elastic_slip = 0.03, viscous_velocity = 100, point_spacing = 0.35; // mm, mm/s, mm
  int points_per_side = 8, passes = 2;
  std::vector<std::string> self = {"backbone", "balloon"};
  solver::Enforcement enforcement = solver::Enforcement::penalty;
  double augmentation_tolerance = 0.01; // mm
  int max_augmentations = 10;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("friction", self.friction, "1", 0, 10, "Coulomb coefficient");
    v.quantity("stiffness", self.stiffness, "MPa/mm", 0, 1e6, "contact pressure per penetration");
    v.quantity("thickness", self.thickness, "mm", 0, 10,
               "how far a surface is moved back into its body; rounds its edges by the same radius");
    v.quantity("onset", self.onset, "mm", 0, 1, "penetration over which the stiffness grows from zero");
    v.count(
        "points_per_side", self.points_per_side, 2, 20,
        "contact points per side of a balloon element; their distance must stay below the thickness when it stretches");
    v.count("passes", self.passes, 1, 2,
            "2: points of the ribs, edges and corners included, feel the balloon too, half the area each");
    v.quantity("point_spacing", self.point_spacing, "mm", 0, 10,
               "largest distance of the points of the ribs; 0 mm: half the thickness");
    v.quantity("elastic_slip", self.elastic_slip, "mm", 1e-9, 10,
               "how far the surfaces give before they slide: friction builds up over it and is kept from step to step");
    v.quantity(
        "viscous_velocity", self.viscous_velocity, "mm/s", 1e-6, 1e9,
        "sliding speed at which friction has doubled: a regularisation that keeps a balloon from jumping when it "
        "begins to slide");
    v.quantity("penetration_limit", self.penetration_limit, "mm", 0, 10, "a step that ends deeper is rejected");
    v.words("self", self.self, {"backbone", "balloon"},
            "parts that may touch themselves: ribs, folds, head and base each other; the balloon's folds and domes");
    solver::augmentation_fields(self, v);
  }
};

/// The block [output].
struct Output {
  int shape_every = 5;
  bool vtu = true;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.count("shape_every", self.shape_every, 1, 1000000,
            "steps between the shapes kept in history.h5 and fields/; the last is kept");
    v.flag("vtu", self.vtu, "also write the whole fields of these shapes, as VTU files for ParaView");
  }
};

/// The block [parallel].
struct Parallel {
  int ranks_per_evaluation = 1;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.count("ranks_per_evaluation", self.ranks_per_evaluation, 1, 100000, "MPI ranks that share one simulation");
  }
};

/// Everything a study file can say. Blocks that do not belong to the kind of actuator are not visited, so their keys
/// are unknown there.
struct Study {
  Title title;
  Actuator actuator;
  std::vector<solver::Material> materials;
  solver::Vector3 gravity = {0, 0, 0}; // mm/s^2
  solver::Path path;
  solver::Newton newton;
  geometry::MeshSizes mesh;
  ContactDefaults contact;
  Judge judge;
  std::vector<Variable> variables;
  Method method;
  std::optional<optimize::Objective> objective;
  std::vector<Constraint> constraints;
  Output output;
  Parallel parallel;
  // kind mesh
  std::vector<solver::Body> bodies;
  std::vector<solver::Support> supports;
  std::vector<solver::Cavity> cavities; // none or one
  std::vector<solver::Load> loads;
  std::vector<solver::ContactPair> contact_pairs;
  std::vector<solver::RigidBody> rigid_bodies;
  std::vector<solver::Response> responses;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.group("study", self.title, "what the study is about");
    v.group("actuator", self.actuator, "what is inflated");
    v.named_groups("material", self.materials, "materials by name");
    v.point("gravity", self.gravity, "mm/s^2", "acceleration of gravity; stands above the first [block]");
    if (self.actuator.kind == ActuatorKind::mesh)
      problem_fields(self, v);
    else
      actuator_fields(self, v);
    v.group("path", self.path, "how the path is driven");
    v.group("newton", self.newton, "when a step is solved");
    v.group_list("variable", self.variables, "what is varied");
    v.group("method", self.method, "what is done with the variables");
    v.group("objective", self.objective, "the response that is to be made large or small");
    v.group_list("constraint", self.constraints, "bounds on responses");
    v.group("output", self.output, "what is kept of a simulation");
    v.group("parallel", self.parallel, "use of MPI ranks");
  }

private:
  template <class Self, class Visitor>
  static void actuator_fields(Self &self, Visitor &v)
  {
    v.group("mesh", self.mesh, "numbers of elements");
    v.group("contact", self.contact, "contact between the parts of the actuator");
    if (self.actuator.kind == ActuatorKind::pebs)
      v.group_list("rigid", self.rigid_bodies, "obstacles: rigid bodies in closed form, fixed in space");
    v.group("judge", self.judge, "thresholds of stages and instabilities");
  }

  template <class Self, class Visitor>
  static void problem_fields(Self &self, Visitor &v)
  {
    v.group_list("body", self.bodies, "bodies of the mesh");
    v.group_list("support", self.supports, "where they are held");
    v.group_list("cavity", self.cavities, "the driven cavity");
    v.group_list("load", self.loads, "dead and follower loads");
    v.group_list("contact_pair", self.contact_pairs, "surfaces that touch");
    v.group_list("rigid", self.rigid_bodies, "rigid bodies in closed form, fixed in space");
    v.group_list("response", self.responses, "what is measured");
  }
};

/// The defaults of a kind of actuator, before the study file is read.
Study default_study(ActuatorKind kind);

/// The material of that name. Throws std::invalid_argument when there is none.
const solver::Material &material_named(const Study &, const std::string &name);

} // namespace ballonet::studies
