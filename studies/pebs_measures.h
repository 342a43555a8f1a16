// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/pebs_mesh.h"
#include "studies/balloon_measures.h"
#include "studies/rigid_frame.h"
#include <optional>
#include <vector>

namespace ballonet::studies
{

/// What the shape of a deformed PEBS amounts to. Lengths in mm, angles in deg.
struct PebsMeasures {
  double bending_angle = 0; ///< head normal against the vertical in the x-z plane, positive towards the wall (-x)
  double twist = 0;         ///< of the head about its own normal, right-handed
  double out_of_plane = 0;  ///< head normal against the x-z plane, positive towards +y
  std::vector<double> gaps; ///< relative bending of neighbouring ribs; the first between base and rib 1
  Point tip = {0, 0, 0};    ///< middle of the head disc, on its axis
  double axial_ratio = 1, radial_ratio = 1; ///< of the balloon, see BalloonGauge
  double max_bulge = 0;    ///< largest distance of balloon nodes from the cage's axis beyond the ribs' inner radius
  double localisation = 1; ///< the same of single gaps, none counted below 0: the largest over the mean
  double rib_opening = 0;  ///< largest growth of a rib node's distance from the axis, in the rib's own frame
};

/// Measures a deformed PEBS from the positions of its nodes alone.
class PebsGauge
{
public:
  /// `symmetric`: only the half y >= 0 is meshed.
  PebsGauge(geometry::PebsLayout layout, std::vector<Point> reference, bool symmetric);

  /// `previous_angle`: bending angle of the state before, which decides about whole turns.
  PebsMeasures measure(const std::vector<Point> &deformed, double previous_angle) const;

private:
  /// Frames of the base (at rest) and of every rib, from the bottom.
  std::vector<RigidFrame> rib_frames(const std::vector<Point> &deformed) const;
  /// Largest excess of the balloon's radius over the cage's in each gap; minus that radius where there is none.
  std::vector<double> gap_bulges(const std::vector<Point> &deformed, const std::vector<RigidFrame> &frames) const;
  double rib_opening(const std::vector<Point> &deformed, const std::vector<RigidFrame> &frames) const;

  geometry::PebsLayout layout_;
  std::vector<Point> reference_;
  bool symmetric_;
  std::optional<BalloonGauge> balloon_; // none in a backbone without balloon
};

/// The axis of the cage between two ribs: a cubic that starts and ends in the ribs' centres along their normals.
class CageAxis
{
public:
  struct Station {
    Point centre, normal;
  };
  explicit CageAxis(std::vector<Station> stations) : stations_(std::move(stations)) {}

  /// A gap between two stations and the distance of a point from the axis there.
  struct Place {
    std::size_t gap = 0;
    double radius = 0;
  };

  /// The place of a point, in the cross-section interpolated between the two stations it lies between; nothing if it
  /// lies between none, or only between two that are far from it, as beyond an end of a cage that is curled up.
  std::optional<Place> place_of(const Point &point) const;

private:
  std::optional<double> radius_in_gap(const Point &point, std::size_t gap) const;

  std::vector<Station> stations_;
};

/// Largest over mean of the bulges of all gaps, where what is below 0 counts as 0; 1 if none bulges. From 1 (all alike)
/// to the number of gaps (a single one).
double localisation_index(const std::vector<double> &gap_bulges);

/// Share of ribs of which at least `arc_share` is touched. `rib_cells`: the cells along each rib's inner side;
/// `touched`: which cells of the mesh have a point of contact.
double touched_share(const std::vector<std::vector<std::uint32_t>> &rib_cells, const std::vector<bool> &touched,
                     double arc_share);

} // namespace ballonet::studies
