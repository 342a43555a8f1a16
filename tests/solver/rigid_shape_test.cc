// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/rigid_shape.h"
#include <catch2/catch.hpp>
#include <random>

using namespace ballonet::solver;
using namespace ballonet::solver::contact;

namespace
{

RigidBody body(RigidShapeKind kind)
{
  RigidBody b;
  b.name = "body", b.shape = kind, b.point = {0.3, -0.2, 0.5}, b.axis = {1, 2, 2}, b.radius = 1.3;
  b.half_lengths = {1, 1.5, 0.7};
  return b;
}

constexpr auto kinds = {RigidShapeKind::plane, RigidShapeKind::cylinder, RigidShapeKind::box,
                        RigidShapeKind::ellipsoid};

std::vector<Point3> points_around()
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> where(-2.5, 2.5);
  std::vector<Point3> points;
  for (int k = 0; k < 60; ++k)
    points.push_back(Point3({where(generator), where(generator), where(generator)}));
  return points;
}

Point3 unit(int i)
{
  Point3 e;
  e[i] = 1;
  return e;
}

} // namespace

TEST_CASE("rigid shapes: gradient and hessian are derivatives of the signed distance, the gradient a unit vector")
{
  constexpr double h = 1e-5;
  for (const auto kind : kinds) {
    const auto shape = make_rigid_shape(body(kind));
    int outside = 0;
    for (const Point3 &x : points_around()) {
      const SignedDistance d = shape->distance(x);
      if (d.value < -0.3)
        continue; // deep inside the nearest point is not unique
      outside += d.value > 0;
      CHECK(d.gradient.norm() == Approx(1).epsilon(1e-12));
      for (int i = 0; i < 3; ++i) {
        const auto plus = shape->distance(x + h * unit(i)), minus = shape->distance(x - h * unit(i));
        CHECK(d.gradient[i] == Approx((plus.value - minus.value) / (2 * h)).margin(1e-8));
        for (int j = 0; j < 3; ++j)
          CHECK(d.hessian[j][i] == Approx((plus.gradient[j] - minus.gradient[j]) / (2 * h)).margin(1e-7));
      }
    }
    CHECK(outside > 10);
  }
}

TEST_CASE("rigid shapes: going back along the gradient by the distance ends on the surface")
{
  for (const auto kind : kinds) {
    const auto shape = make_rigid_shape(body(kind));
    for (const Point3 &x : points_around()) {
      const SignedDistance d = shape->distance(x);
      if (d.value > 0)
        CHECK(std::abs(shape->distance(x - d.value * d.gradient).value) < 1e-10);
    }
  }
}

TEST_CASE("rigid shapes: known distances")
{
  RigidBody plane = body(RigidShapeKind::plane), sphere = body(RigidShapeKind::ellipsoid);
  sphere.half_lengths = {2, 2, 2};
  const Point3 centre({0.3, -0.2, 0.5});
  CHECK(make_rigid_shape(plane)->distance(centre + Point3({1, 2, 2})).value == Approx(3));
  CHECK(make_rigid_shape(body(RigidShapeKind::cylinder))->distance(centre + Point3({2, -1, 0})).value ==
        Approx(std::sqrt(5.) - 1.3));
  CHECK(make_rigid_shape(body(RigidShapeKind::box))->distance(centre + Point3({4, 5.5, 0})).value == Approx(5));
  CHECK(make_rigid_shape(body(RigidShapeKind::box))->distance(centre + Point3({0, 0, 0.6})).value == Approx(-0.1));
  CHECK(make_rigid_shape(sphere)->distance(centre + Point3({3, 0, 4})).value == Approx(3));
  CHECK(make_rigid_shape(sphere)->distance(centre + Point3({1, 0, 0})).value == Approx(-1));
  CHECK(make_rigid_shape(body(RigidShapeKind::ellipsoid))->distance(centre + Point3({0, 0, 1})).value == Approx(0.3));
}

TEST_CASE("rigid shapes: lengths that are not positive are refused")
{
  RigidBody plane = body(RigidShapeKind::plane), cylinder = body(RigidShapeKind::cylinder),
            box = body(RigidShapeKind::box);
  plane.axis = {0, 0, 0};
  cylinder.radius = 0;
  box.half_lengths[1] = -1;
  for (const auto &wrong : {plane, cylinder, box})
    CHECK_THROWS_AS(make_rigid_shape(wrong), std::invalid_argument);
}
