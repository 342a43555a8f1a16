// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/rigid_shape.h"
#include <algorithm>
#include <cmath>
#include <deal.II/base/symmetric_tensor.h>
#include <stdexcept>

namespace ballonet::solver::contact
{

namespace
{

using Matrix = dealii::Tensor<2, 3>;

Point3 to_point(const Vector3 &v) { return Point3({v[0], v[1], v[2]}); }

Matrix identity() { return Matrix(dealii::unit_symmetric_tensor<3>()); }

/// The half space below a plane.
class Plane : public RigidShape
{
public:
  Plane(const Point3 &point, const Point3 &normal) : point_(point), normal_(normal) {}
  SignedDistance distance(const Point3 &x) const override { return {normal_ * (x - point_), normal_, {}}; }

private:
  Point3 point_, normal_;
};

/// Without ends.
class Cylinder : public RigidShape
{
public:
  Cylinder(const Point3 &point, const Point3 &axis, double radius) : point_(point), axis_(axis), radius_(radius) {}

  SignedDistance distance(const Point3 &x) const override
  {
    const Point3 r = x - point_, across = r - (r * axis_) * axis_;
    const double length = std::max(across.norm(), 1e-12 * radius_);
    const Point3 normal = across / length;
    return {length - radius_, normal,
            (identity() - outer_product(axis_, axis_) - outer_product(normal, normal)) / length};
  }

private:
  Point3 point_, axis_;
  double radius_;
};

/// Along the axes of space. Outside, the closest point is on a face, an edge or a corner; inside, the nearest face
/// counts.
class Cuboid : public RigidShape
{
public:
  Cuboid(const Point3 &centre, const Point3 &half) : centre_(centre), half_(half) {}

  SignedDistance distance(const Point3 &x) const override
  {
    const Point3 r = x - centre_;
    Point3 beyond, outside;
    Matrix directions; // in which the point is outside
    for (int i = 0; i < 3; ++i) {
      beyond[i] = std::abs(r[i]) - half_[i];
      outside[i] = std::copysign(std::max(beyond[i], 0.), r[i]);
      directions[i][i] = beyond[i] > 0;
    }
    const double length = outside.norm();
    if (length == 0)
      return inside(r, beyond);
    const Point3 normal = outside / length;
    return {length, normal, (directions - outer_product(normal, normal)) / length};
  }

private:
  Point3 centre_, half_;

  static SignedDistance inside(const Point3 &r, const Point3 &beyond)
  {
    int nearest = 0;
    for (int i = 1; i < 3; ++i)
      if (beyond[i] > beyond[nearest])
        nearest = i;
    Point3 normal;
    normal[nearest] = r[nearest] < 0 ? -1 : 1;
    return {beyond[nearest], normal, {}};
  }
};

/// Along the axes of space; a sphere when the half axes are equal.
class Ellipsoid : public RigidShape
{
public:
  Ellipsoid(const Point3 &centre, const Point3 &half) : centre_(centre), half_(half) {}

  /// With F(y) = sum (y_i / a_i)^2 - 1 and the curvature S of the surface at the closest point y, in its tangent plane,
  /// the hessian of the distance d is S (1 + d S)^-1 (Gilbarg and Trudinger 2001, lemma 14.17).
  SignedDistance distance(const Point3 &x) const override
  {
    const Point3 r = x - centre_, y = closest(r);
    Point3 slope;
    Matrix second;
    for (int i = 0; i < 3; ++i) {
      slope[i] = y[i] / (half_[i] * half_[i]);
      second[i][i] = 1 / (half_[i] * half_[i]);
    }
    const Point3 normal = slope / slope.norm();
    const double value = (r - y) * normal;
    const Matrix in_plane = identity() - outer_product(normal, normal);
    const Matrix curvature = in_plane * second * in_plane / slope.norm();
    return {value, normal, curvature * invert(identity() + value * curvature)};
  }

private:
  Point3 centre_, half_;

  /// y_i = a_i^2 r_i / (a_i^2 + t), where t is the largest root of sum (a_i r_i / (a_i^2 + t))^2 = 1 (Eberly 2013). The
  /// sum falls with t and is convex, so Newton's method from the left of the root is monotone.
  Point3 closest(const Point3 &r) const
  {
    double t = -1e300;
    for (int i = 0; i < 3; ++i)
      t = std::max(t, half_[i] * std::abs(r[i]) - half_[i] * half_[i]); // one term alone is 1 there
    for (int iteration = 0; iteration < 100; ++iteration) {
      double excess = -1, slope = 0;
      for (int i = 0; i < 3; ++i) {
        const double term = half_[i] * r[i] / (half_[i] * half_[i] + t);
        excess += term * term;
        slope -= 2 * term * term / (half_[i] * half_[i] + t);
      }
      const double step = -excess / slope;
      t += step;
      if (std::abs(step) <= 1e-15 * half_.norm_square())
        break;
    }
    Point3 y;
    for (int i = 0; i < 3; ++i)
      y[i] = half_[i] * half_[i] * r[i] / (half_[i] * half_[i] + t);
    return y;
  }
};

} // namespace

std::unique_ptr<RigidShape> make_rigid_shape(const RigidBody &body)
{
  auto require = [&](bool holds, const char *what) {
    if (!holds)
      throw std::invalid_argument("rigid body \"" + body.name + "\": " + what);
  };
  const Point3 point = to_point(body.point), half = to_point(body.half_lengths);
  const double length = to_point(body.axis).norm();
  const bool has_axis = body.shape == RigidShapeKind::plane || body.shape == RigidShapeKind::cylinder;
  require(!has_axis || length > 0, "the axis has no length");
  require(has_axis || std::min({half[0], half[1], half[2]}) > 0, "half_lengths must be positive");
  switch (body.shape) {
  case RigidShapeKind::plane:
    return std::make_unique<Plane>(point, to_point(body.axis) / length);
  case RigidShapeKind::cylinder:
    require(body.radius > 0, "the radius must be positive");
    return std::make_unique<Cylinder>(point, to_point(body.axis) / length, body.radius);
  case RigidShapeKind::box:
    return std::make_unique<Cuboid>(point, half);
  case RigidShapeKind::ellipsoid:
    break;
  }
  return std::make_unique<Ellipsoid>(point, half);
}

} // namespace ballonet::solver::contact
