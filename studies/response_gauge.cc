// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/response_gauge.h"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

using Kind = solver::ResponseKind;
using Vector = std::array<double, 3>;

double distance(const Vector &a, const Vector &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

std::uint32_t nearest_node(const geometry::Mesh &mesh, const Vector &point)
{
  const auto nearest = std::min_element(mesh.nodes.begin(), mesh.nodes.end(), [&](const Vector &a, const Vector &b) {
    return distance(a, point) < distance(b, point);
  });
  return static_cast<std::uint32_t>(nearest - mesh.nodes.begin());
}

/// Where a response of nodes is measured.
std::vector<std::uint32_t> nodes_of(const solver::Response &response, const geometry::Mesh &mesh)
{
  if (response.point)
    return {nearest_node(mesh, *response.point)};
  return response.nodes.empty() ? surface_nodes(mesh, response.surface) : set_nodes(mesh, response.nodes);
}

/// "x", "y", "z" or "magnitude" of a vector.
double component(const Vector &v, const std::string &name)
{
  return name == "magnitude" ? std::hypot(v[0], v[1], v[2]) : v[static_cast<std::size_t>(name[0] - 'x')];
}

Vector scaled(Vector v, double factor)
{
  for (double &x : v)
    x *= factor;
  return v;
}

} // namespace

ResponseGauge::ResponseGauge(const SimulationModel &model) : model_(model)
{
  for (const solver::Response &response : model.parameters.responses) {
    Target target{response, {}, 0};
    const bool of_nodes =
        response.kind == Kind::displacement || response.kind == Kind::position || response.kind == Kind::reaction;
    if (of_nodes)
      target.nodes = nodes_of(response, model.mesh);
    const auto &pairs = model.parameters.contact_pairs;
    if (response.kind == Kind::contact_force) {
      const auto found =
          std::find_if(pairs.begin(), pairs.end(), [&](const auto &p) { return p.name == response.pair; });
      if (found == pairs.end())
        throw std::invalid_argument("there is no contact pair \"" + response.pair + "\"");
      target.pair = static_cast<std::size_t>(found - pairs.begin());
    }
    targets_.push_back(std::move(target));
  }
}

double ResponseGauge::value(const Target &target, const solver::PathPoint &point,
                            const solver::Equilibrium &equilibrium) const
{
  const solver::State &state = point.progress.state;
  const std::string &axis = target.response.component;
  const double share = 1 / static_cast<double>(std::max<std::size_t>(target.nodes.size(), 1));
  switch (target.response.kind) {
  case Kind::displacement:
    return component(scaled(sum_over(target.nodes, state.displacement), share), axis);
  case Kind::position: {
    Vector sum = sum_over(target.nodes, state.displacement);
    for (const std::uint32_t node : target.nodes)
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += model_.mesh.nodes[node][i];
    return component(scaled(sum, share), axis);
  }
  case Kind::reaction:
    return component(sum_over(target.nodes, equilibrium.reactions(state)), axis);
  case Kind::contact_force:
    return component(equilibrium.contacts().summaries(state).at(target.pair).secondary_force, axis);
  case Kind::volume:
    return point.progress.volume;
  case Kind::pressure:
    return state.pressure;
  case Kind::max_stress:
    return largest_in_body(model_.mesh, equilibrium.stresses(state), target.response.body);
  }
  throw std::logic_error("an unknown kind of response");
}

void ResponseGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row)
{
  for (const Target &target : targets_)
    row.emplace_back(target.response.name, value(target, point, equilibrium));
}

} // namespace ballonet::studies
