// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_rigid.h"
#include "solver/contact_quadrature.h"
#include "solver/contact_shift.h"
#include "solver/contact_step.h"
#include <stdexcept>

namespace ballonet::solver
{

using namespace contact;

struct RigidContactWork::PointAt {
  std::size_t index, number; ///< among the points of this rank, of all ranks
  const Patch &face;
  Parameters2 xi;
  std::array<double, 9> shapes;
  double area;
  Point3 x;
  SignedDistance distance;
  double shift; ///< mm, of augmented contact

  double penetration() const { return -distance.value; }
  double shifted_penetration() const { return penetration() + shift; }
};

namespace
{

Vector3 to_array(const Point3 &v) { return {v[0], v[1], v[2]}; }

/// Adds the quadratic form of the sum of nodal values with the given shapes.
void add_form(const std::array<double, 9> &shapes, const dealii::Tensor<2, 3> &form, std::array<double, 27 * 27> &block)
{
  for (int a = 0; a < 9; ++a)
    for (int b = 0; b < 9; ++b)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          block[(3 * a + i) * 27 + 3 * b + j] += shapes[a] * shapes[b] * form[i][j];
}

void check(const ContactPair &pair)
{
  if (pair.primary.size() != 1)
    throw std::invalid_argument("contact pair \"" + pair.name +
                                "\": a rigid body beside other primary surfaces; allowed is " + "one rigid body alone");
  if (pair.thickness <= 0 || pair.stiffness <= 0 || pair.onset < 0 || pair.friction < 0)
    throw std::invalid_argument("contact pair \"" + pair.name +
                                "\": thickness and stiffness must be positive, onset and friction not negative");
}

} // namespace

RigidContactWork::RigidContactWork(const Mesh &mesh, const ContactPair &pair, const RigidBody &body,
                                   const std::function<bool(std::uint32_t cell)> &owned)
    : mesh_(mesh), shape_(make_rigid_shape(body)), law_{pair.stiffness, pair.onset}, friction_(pair.friction),
      viscous_velocity_(pair.viscous_velocity), thickness_(pair.thickness), friction_law_{pair.elastic_slip}
{
  check(pair);
  std::size_t n_points = 0;
  auto faces = patches_of(mesh, pair.secondary, 0);
  for (Patch &face : faces)
    face.points = gauss_points(mesh, face, pair.points_per_side, 1);
  if (pair.enforcement != Enforcement::penalty)
    n_shifts_ = number_shift_nodes(faces);
  for (Patch &face : faces) {
    face.first_point = n_points_of_all_ranks_;
    n_points_of_all_ranks_ += face.points.size();
    if (!owned(face.face.cell))
      continue;
    n_points += face.points.size();
    faces_.push_back(std::move(face));
  }
  sliding_.resize(n_points);
  stored_pressure_.resize(n_points);
}

/// All points, in or out of contact, face by face.
template <class Visit>
void RigidContactWork::for_each(const State &state, Visit visit) const
{
  std::size_t index = 0;
  for (const Patch &face : faces_) {
    const PatchNodes nodes = at_depth(face, CurrentPosition{mesh_, state.displacement});
    std::size_t number = face.first_point;
    for (const QuadraturePoint &point : face.points) {
      const auto shapes = patch_shapes(point.xi).value;
      const Point3 x = interpolate(nodes, shapes);
      visit(PointAt{index++, number++, face, point.xi, shapes, point.area, x, shape_->distance(x),
                    shift_at(face, point.xi, shifts_)});
    }
  }
}

Point3 RigidContactWork::slip(const PointAt &p) const
{
  return in_plane(p.x - sliding_[p.index].start, sliding_[p.index].friction.normal);
}

/// On the secondary surface, N.
Point3 RigidContactWork::force(const PointAt &p) const
{
  Point3 force = p.area * law_.pressure(p.shifted_penetration()) * p.distance.gradient;
  if (const FrictionPoint &friction = sliding_[p.index].friction; friction.limit > 0)
    force -= friction_law_.force(friction, slip(p));
  return force;
}

std::size_t RigidContactWork::number_shifts_from(std::size_t first)
{
  first_shift_ = first;
  return first + n_shifts_;
}

void RigidContactWork::take_shifts(const State &state)
{
  const auto shifts = shifts_of_pair(state, first_shift_, n_shifts_);
  shifts_.assign(shifts.begin(), shifts.end());
}

void RigidContactWork::add_gaps(const State &state, MeanGaps &gaps) const
{
  for_each(state, [&](const PointAt &p) {
    if (p.shifted_penetration() > 0)
      gaps.add(p.face, p.xi, first_shift_, p.area * law_.pressure(p.shifted_penetration()), p.penetration());
  });
}

void RigidContactWork::begin_step(const State &start, const Step &step)
{
  take_shifts(start);
  friction_law_.viscous_slip = viscous_velocity_ * step.rate_time();
  for_each(start, [&](const PointAt &p) {
    stored_pressure_[p.index] = law_.pressure(p.shifted_penetration());
    const Point3 traction = remembered_traction(start, first_point_ + p.number);
    sliding_[p.index] = {
        friction_law_.begin(friction_ * stored_pressure_[p.index], p.area, p.distance.gradient, traction), p.x};
  });
}

std::size_t RigidContactWork::number_points_from(std::size_t first)
{
  first_point_ = first;
  return first + n_points_of_all_ranks_;
}

void RigidContactWork::end_step(State &end) const
{
  for_each(end, [&](const PointAt &p) {
    if (const FrictionPoint &friction = sliding_[p.index].friction; friction.limit > 0)
      remember_traction(end, first_point_ + p.number, friction_law_.remembered_force(friction, slip(p)) / p.area);
  });
}

double RigidContactWork::energy(const State &state) const
{
  double sum = 0;
  for_each(state, [&](const PointAt &p) {
    sum += p.area * law_.energy(p.shifted_penetration());
    if (const FrictionPoint &friction = sliding_[p.index].friction; friction.limit > 0)
      sum += friction_law_.energy(friction, slip(p));
  });
  return sum;
}

void RigidContactWork::residual(const State &state, Assembly &assembly) const
{
  for_each(state, [&](const PointAt &p) {
    const Point3 f = force(p);
    if (f.norm_square() == 0)
      return;
    std::array<double, 27> values;
    for (int a = 0; a < 9; ++a)
      for (int i = 0; i < 3; ++i)
        values[3 * a + i] = -p.shapes[a] * f[i];
    assembly.add_residual(p.face.nodes, values);
  });
}

void RigidContactWork::tangent(const State &state, Assembly &assembly) const
{
  const Patch *present = nullptr;
  std::array<double, 27 * 27> block{};
  auto flush = [&] {
    if (present)
      assembly.add_tangent(present->nodes, block);
    block.fill(0);
  };
  for_each(state, [&](const PointAt &p) {
    const FrictionPoint &friction = sliding_[p.index].friction;
    if (p.shifted_penetration() <= 0 && friction.limit == 0)
      return;
    if (present != &p.face)
      flush();
    present = &p.face;
    const Point3 &n = p.distance.gradient;
    const double stress = convex_ || p.shifted_penetration() <= 0 ? 0 : stored_pressure_[p.index];
    dealii::Tensor<2, 3> form =
        p.area * (law_.slope(p.shifted_penetration()) * outer_product(n, n) - stress * p.distance.hessian);
    if (friction.limit > 0)
      form += friction_law_.tangent(friction, slip(p));
    add_form(p.shapes, form, block);
  });
  flush();
}

void RigidContactWork::advance(const State &from, std::span<const double> increment, double fraction)
{
  for_each(from, [&](const PointAt &p) {
    const Point3 way = interpolate(at_depth(p.face, NodalField{increment}), p.shapes);
    const double predicted = law_.pressure(p.shifted_penetration()) -
                             law_.slope(p.shifted_penetration()) * fraction * (p.distance.gradient * way);
    stored_pressure_[p.index] = std::max(predicted, 0.);
  });
}

double RigidContactWork::largest_step(const State &state, std::span<const double> increment) const
{
  const double deepest = (1 - core_share) * thickness_;
  double fraction = 1;
  for_each(state, [&](const PointAt &p) {
    const Point3 way = interpolate(at_depth(p.face, NodalField{increment}), p.shapes);
    if (const double speed = way.norm(); speed > 0)
      fraction = fraction_above([&](double f) { return shape_->distance(p.x + f * way).value; }, speed, -deepest,
                                core_share * thickness_, fraction);
  });
  return fraction;
}

ContactSummary RigidContactWork::summary(const State &state) const
{
  ContactSummary summary;
  Point3 sum;
  for_each(state, [&](const PointAt &p) {
    sum += force(p);
    if (p.shifted_penetration() <= 0)
      return;
    summary.normal_force += p.area * law_.pressure(p.shifted_penetration());
    summary.area += p.area;
    summary.penetration = std::max(summary.penetration, p.penetration());
    ++summary.points;
  });
  for (const Patch &face : faces_)
    for (const Node n : face.nodes)
      summary.penetration =
          std::max(summary.penetration, -shape_->distance(CurrentPosition{mesh_, state.displacement}(n)).value);
  summary.secondary_force = to_array(sum);
  summary.primary_force = {to_array(-sum)};
  return summary;
}

std::vector<ContactPoint> RigidContactWork::contact_points(const State &state) const
{
  std::vector<ContactPoint> points;
  for_each(state, [&](const PointAt &p) {
    if (p.shifted_penetration() > 0)
      points.push_back(
          {p.face.face, std::nullopt, to_array(p.x), p.area, law_.pressure(p.shifted_penetration()), p.penetration()});
  });
  return points;
}

} // namespace ballonet::solver
