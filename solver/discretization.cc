// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/discretization.h"
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/data_out.h>
#include <stdexcept>

namespace ballonet::solver
{

using namespace dealii;
using Tria = parallel::shared::Triangulation<3>;

struct Discretization::DealII {
  explicit DealII(MPI_Comm comm)
      : triangulation(comm, Triangulation<3>::none, false, Tria::partition_custom_signal), element(FE_Q<3>(2), 3),
        dofs(triangulation), mapping(2),
        values(mapping, scalar, QGauss<3>(3), update_gradients | update_JxW_values | update_quadrature_points)
  {
  }
  Tria triangulation;
  FE_Q<3> scalar{2};
  FESystem<3> element;
  DoFHandler<3> dofs;
  MappingQCache<3> mapping;
  FEValues<3> values;
  /// lexicographic[h]: lexicographic number of the h-th node in deal.II's order
  std::vector<unsigned int> lexicographic = FETools::hierarchic_to_lexicographic_numbering<3>(2);
};

namespace
{

/// Every body is a chain of cells in mesh order: equal slices of each body give every rank its share of all work.
std::vector<unsigned int> owners(const Mesh &mesh, unsigned int n_ranks)
{
  std::vector<std::size_t> size(mesh.bodies.size()), seen(mesh.bodies.size());
  for (const auto body : mesh.cell_body)
    ++size[body];
  std::vector<unsigned int> owner;
  for (const auto body : mesh.cell_body)
    owner.push_back(n_ranks * seen[body]++ / size[body]);
  return owner;
}

/// Corner nodes only: deal.II's vertices, numbered without gaps.
std::pair<std::vector<Point<3>>, std::vector<CellData<3>>> corners(const Mesh &mesh)
{
  std::vector<int> vertex(mesh.nodes.size(), -1);
  std::vector<Point<3>> points;
  std::vector<CellData<3>> cells(mesh.cells.size(), CellData<3>(8));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int v = 0; v < 8; ++v) {
      const Node node = mesh.cells[c][2 * (v & 1) + 6 * (v >> 1 & 1) + 18 * (v >> 2)];
      if (vertex[node] < 0) {
        vertex[node] = points.size();
        points.emplace_back(mesh.nodes[node][0], mesh.nodes[node][1], mesh.nodes[node][2]);
      }
      cells[c].vertices[v] = vertex[node];
    }
  return {points, cells};
}

/// The item of that name; throws std::invalid_argument that lists the known names.
template <class Named>
const Named &named(const std::vector<Named> &items, const std::string &name, const std::string &what)
{
  std::string known;
  for (const Named &item : items) {
    if (item.name == name)
      return item;
    known += (known.empty() ? "" : ", ") + item.name;
  }
  throw std::invalid_argument("the mesh has no " + what + " \"" + name +
                              "\"; it has: " + (known.empty() ? "none" : known));
}

} // namespace

Discretization::Discretization(const Mesh &mesh, MPI_Comm comm)
    : mesh_(mesh), comm_(comm), deal_(std::make_unique<DealII>(comm)), owned_(mesh.cells.size()),
      block_(mesh.nodes.size())
{
  auto &tria = deal_->triangulation;
  const auto owner = owners(mesh, Utilities::MPI::n_mpi_processes(comm));
  tria.signals.create.connect([&] {
    for (const auto &cell : tria.active_cell_iterators())
      cell->set_subdomain_id(owner[cell->active_cell_index()]);
  });
  const auto [points, cells] = corners(mesh);
  tria.create_triangulation(points, cells, SubCellData());

  deal_->mapping.initialize(tria, [&](const Triangulation<3>::cell_iterator &cell) {
    std::vector<Point<3>> support;
    for (const auto l : deal_->lexicographic) {
      const auto &x = mesh.nodes[mesh.cells[cell->index()][l]];
      support.emplace_back(x[0], x[1], x[2]);
    }
    return support;
  });

  deal_->dofs.distribute_dofs(deal_->element);
  std::vector<types::global_dof_index> dofs(81);
  for (const auto &cell : deal_->dofs.active_cell_iterators()) {
    const auto c = cell->active_cell_index();
    cell->get_dof_indices(dofs);
    for (unsigned int i = 0; i < 81; ++i)
      if (const auto [component, h] = deal_->element.system_to_component_index(i); component == 0)
        block_[mesh.cells[c][deal_->lexicographic[h]]] = dofs[i] / 3;
    if (cell->is_locally_owned()) {
      owned_cells_.push_back(c);
      owned_[c] = true;
    }
  }
  const auto &owned = deal_->dofs.locally_owned_dofs();
  const int first = owned.n_elements() ? *owned.begin() : 0;
  owned_blocks_ = {first / 3, first / 3 + static_cast<int>(owned.n_elements()) / 3};
}

Discretization::~Discretization() = default;

CellQuadrature Discretization::quadrature(std::uint32_t cell) const
{
  auto &values = deal_->values;
  values.reinit(Triangulation<3>::active_cell_iterator(&deal_->triangulation, 0, cell));
  CellQuadrature q;
  for (int p = 0; p < n_points; ++p) {
    q.weight[p] = values.JxW(p);
    if (!(q.weight[p] > 0))
      throw std::invalid_argument("cell " + std::to_string(cell) + " of the mesh is inverted");
    for (int d = 0; d < 3; ++d)
      q.position[p][d] = values.quadrature_point(p)[d];
    for (int h = 0; h < n_cell_nodes; ++h)
      for (int d = 0; d < 3; ++d)
        q.gradient[p][deal_->lexicographic[h]][d] = values.shape_grad(h, p)[d];
  }
  return q;
}

void Discretization::write_vtu(const std::string &directory, const std::string &name, const State &state,
                               const std::vector<double> &cell_values, const std::string &value_name) const
{
  Vector<double> displacement(deal_->dofs.n_dofs()), value(deal_->triangulation.n_active_cells());
  for (std::size_t node = 0; node < n_nodes(); ++node)
    for (int d = 0; d < 3; ++d)
      displacement[3 * block_[node] + d] = state.displacement[3 * node + d];
  std::copy(cell_values.begin(), cell_values.end(), value.begin());
  Vector<float> body(value.size());
  std::copy(mesh_.cell_body.begin(), mesh_.cell_body.end(), body.begin());

  DataOut<3> out;
  DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = true;
  flags.time = state.time;
  out.set_flags(flags);
  using Interpretation = DataComponentInterpretation::DataComponentInterpretation;
  const std::vector<Interpretation> vector(3, DataComponentInterpretation::component_is_part_of_vector);
  out.add_data_vector(deal_->dofs, displacement, std::vector<std::string>(3, "displacement"), vector);
  out.add_data_vector(value, value_name, DataOut<3>::type_cell_data);
  out.add_data_vector(body, "body", DataOut<3>::type_cell_data);
  out.build_patches(deal_->mapping, 2, DataOut<3>::curved_inner_cells);
  out.write_vtu_in_parallel(directory + "/" + name + ".vtu", comm_);
}

std::array<Node, n_face_nodes> face_nodes(const Mesh &mesh, Face face)
{
  // first node, step along xi and along eta; xi x eta points outwards
  static constexpr int start[6] = {0, 2, 0, 6, 0, 18};
  static constexpr int step[6][2] = {{9, 3}, {3, 9}, {1, 9}, {9, 1}, {3, 1}, {1, 3}};
  std::array<Node, n_face_nodes> nodes;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i)
      nodes[i + 3 * j] = mesh.cells[face.cell][start[face.local] + i * step[face.local][0] + j * step[face.local][1]];
  return nodes;
}

const FaceBasis &face_basis()
{
  static const FaceBasis basis = [] {
    FaceBasis b;
    const FE_Q<2> element(2);
    const QGauss<2> gauss(3);
    const auto lexicographic = FETools::hierarchic_to_lexicographic_numbering<2>(2);
    for (int p = 0; p < n_face_nodes; ++p) {
      b.weight[p] = gauss.weight(p);
      for (int h = 0; h < n_face_nodes; ++h) {
        b.value[p][lexicographic[h]] = element.shape_value(h, gauss.point(p));
        for (int d = 0; d < 2; ++d)
          b.derivative[p][lexicographic[h]][d] = element.shape_grad(h, gauss.point(p))[d];
      }
    }
    return b;
  }();
  return basis;
}

const std::vector<Face> &faces_of(const Mesh &mesh, const std::string &surface)
{
  return named(mesh.surfaces, surface, "surface").faces;
}

const std::vector<Node> &nodes_of_set(const Mesh &mesh, const std::string &set)
{
  return named(mesh.node_sets, set, "set of nodes").nodes;
}

std::vector<Node> nodes_of_place(const Mesh &mesh, const std::string &surface, const std::string &set)
{
  if (surface.empty() == set.empty())
    throw std::invalid_argument("a place is named either as a surface or as a set of nodes; given are surface \"" +
                                surface + "\" and nodes \"" + set + "\"");
  return set.empty() ? surface_nodes(mesh, surface) : nodes_of_set(mesh, set);
}

std::vector<Node> surface_nodes(const Mesh &mesh, const std::string &surface)
{
  std::vector<bool> marked(mesh.nodes.size());
  for (const auto &face : faces_of(mesh, surface))
    for (const auto node : face_nodes(mesh, face))
      marked[node] = true;
  std::vector<Node> nodes;
  for (Node node = 0; node < marked.size(); ++node)
    if (marked[node])
      nodes.push_back(node);
  return nodes;
}

} // namespace ballonet::solver
