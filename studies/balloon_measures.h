// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/pebs_mesh.h"
#include "studies/rigid_frame.h"

namespace ballonet::studies
{

/// Length and radius of an inflated balloon, from the rings of nodes of its tubular part.
class BalloonGauge
{
public:
  /// `symmetric`: only the half y >= 0 is meshed. Throws std::invalid_argument without at least two rings and a tip.
  BalloonGauge(const geometry::PebsLayout &layout, const std::vector<Point> &reference, bool symmetric);

  /// Length along the centre line, through the ring centres to the tip, over the same at rest.
  double axial_ratio(const std::vector<Point> &deformed) const { return length(deformed) / rest_length_; }

  /// Mean distance of the outer nodes from their ring's centre over the same at rest.
  double radial_ratio(const std::vector<Point> &deformed) const { return radius(deformed) / rest_radius_; }

private:
  struct Ring {
    std::vector<std::uint32_t> nodes;
    std::vector<double> weights; ///< share of the whole ring
  };

  Point centre(const Ring &ring, const std::vector<Point> &points) const;
  double length(const std::vector<Point> &points) const;
  double radius(const std::vector<Point> &points) const;

  std::vector<Ring> rings_;
  std::uint32_t tip_ = 0;
  bool symmetric_;
  double rest_length_, rest_radius_;
};

} // namespace ballonet::studies
