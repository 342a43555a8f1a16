// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ballonet::studies
{

/// Thresholds by which a path is divided into stages and classified. Pressures in MPa, angles in degrees.
struct Judge {
  double window_min = 0, window_max = 0.064;
  double head_force_share = 0.02;
  double contact_share = 0.9;
  double rib_arc_share = 0.5;
  int local_gap_first = 15, local_gap_last = 20;
  double local_share = 0.5;
  double snap_drop = 0.02;
  double bulge_limit = 1;
  double escape_bulge = 1;
  double localisation_index = 3;
  double rib_opening = 0.1;
  double participation = 0.5;
  double gap_ratio = 2.5, gap_ratio_angle = 180;
  double angle_fall = 5;
  double droop_angle = 90;
  double overload_angle = 90, overload_index = 1, overload_radius = 0.7;
  double normal_angle = 180;
  double end_angle = 270;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.quantity("window_min", self.window_min, "MPa", 0, 1e3, "lower end of the pressure window that is judged");
    v.quantity("window_max", self.window_max, "MPa", 0, 1e3, "upper end of the pressure window that is judged");
    v.quantity(
        "head_force_share", self.head_force_share, "1", 0, 1,
        "separation ends at the first sustained head force above this share of pressure x balloon cross-section");
    v.quantity("contact_share", self.contact_share, "1", 0, 1,
               "insufficient interaction ends when this share of the ribs is touched");
    v.quantity("rib_arc_share", self.rib_arc_share, "1", 0, 1,
               "a rib counts as touched over at least this share of its arc");
    v.count("local_gap_first", self.local_gap_first, 1, 1000,
            "first of the upper gaps whose share marks local bending");
    v.count("local_gap_last", self.local_gap_last, 1, 1000, "last of the upper gaps whose share marks local bending");
    v.quantity("local_share", self.local_share, "1", 0, 1,
               "bending is local while the upper gaps hold more than this share of the angle increment");
    v.quantity(
        "snap_drop", self.snap_drop, "1", 0, 1,
        "the pressure passes a limit point where it then falls by more than this share; until it is back, a slowly "
        "raised pressure snaps through");
    v.quantity("bulge_limit", self.bulge_limit, "1", 0, 100,
               "interaction_failure: bulge above this multiple of rib thickness + rib width");
    v.quantity("escape_bulge", self.escape_bulge, "1", 0, 100,
               "interaction_failure: a snap-through carries the bulge beyond this multiple of the rib thickness");
    v.quantity(
        "localisation_index", self.localisation_index, "1", 1, 1e3,
        "interaction_failure: largest over mean bulge of the gaps above this past a limit point, with the balloon "
        "beyond escape_bulge");
    v.quantity("rib_opening", self.rib_opening, "1", 0, 10,
               "interaction_failure: opening of a rib above this share of the cage radius");
    v.quantity(
        "participation", self.participation, "1", 0, 1,
        "losing_control: participation (sum theta)^2 / (N sum theta^2) of the gaps below this at the end, if a rib "
        "was touched");
    v.quantity("gap_ratio", self.gap_ratio, "1", 1, 1e3,
               "losing_control: one gap opens by more than this multiple of the mean");
    v.quantity("gap_ratio_angle", self.gap_ratio_angle, "deg", 0, 1e3, "bending angle above which gap_ratio is judged");
    v.quantity("angle_fall", self.angle_fall, "deg", 0, 1e3,
               "losing_control: after rib contact (contact_share) the angle falls back by more than this");
    v.quantity("droop_angle", self.droop_angle, "deg", 0, 1e3,
               "losing_control: the actuator droops further than this, its backbone does not carry it");
    v.quantity("overload_angle", self.overload_angle, "deg", 0, 1e3,
               "overload: less angle than this at the end of the window, because the balloon does not inflate: "
               "overload_index or overload_radius");
    v.quantity("overload_index", self.overload_index, "1", 0, 1e3,
               "overload: limit pressure 1.5 C10 t / R of the balloon over window_max above this");
    v.quantity("overload_radius", self.overload_radius, "1", 0, 1,
               "overload: mean balloon radius at the end below this share of the cage radius");
    v.quantity("normal_angle", self.normal_angle, "deg", 0, 1e3,
               "normal: at least this angle at the end of the window, else weak");
    v.quantity("end_angle", self.end_angle, "deg", 0, 1e3, "the path ends here: the head meets the base");
  }
};

} // namespace ballonet::studies
