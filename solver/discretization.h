// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/types.h"
#include <array>
#include <memory>
#include <mpi.h>
#include <span>
#include <vector>

namespace ballonet::solver
{

/// Number of Gauss points of a cell (3 x 3 x 3), of nodes of a cell and of nodes of a face.
constexpr int n_points = 27, n_cell_nodes = 27, n_face_nodes = 9;

/// What an integral over one cell needs, computed once (total Lagrangian).
struct CellQuadrature {
  std::array<double, n_points> weight;                                            ///< JxW, mm^3
  std::array<std::array<std::array<double, 3>, n_cell_nodes>, n_points> gradient; ///< dN_a/dX, 1/mm
  std::array<std::array<double, 3>, n_points> position;                           ///< X, mm
};

/// What an integral over one face needs on its 3 x 3 Gauss points.
struct FaceBasis {
  std::array<double, n_face_nodes> weight;                          ///< on the unit square
  std::array<std::array<double, n_face_nodes>, n_face_nodes> value; ///< [point][node]
  std::array<std::array<std::array<double, 2>, n_face_nodes>, n_face_nodes> derivative;
};

/// The mesh as deal.II sees it: which cells this rank owns and which equations belong to a node. Every rank knows the
/// whole mesh.
class Discretization
{
public:
  /// Throws std::invalid_argument when a cell is inverted in the reference configuration.
  Discretization(const Mesh &mesh, MPI_Comm comm);
  ~Discretization();

  const Mesh &mesh() const { return mesh_; }
  MPI_Comm comm() const { return comm_; }
  std::size_t n_nodes() const { return mesh_.nodes.size(); }

  /// Cells of this rank, ascending.
  const std::vector<std::uint32_t> &owned_cells() const { return owned_cells_; }
  bool owns(std::uint32_t cell) const { return owned_[cell]; }
  /// Position of the node's three equations in the distributed vectors, divided by three.
  int block(Node node) const { return block_[node]; }
  /// First and one-past-last block of this rank.
  std::pair<int, int> owned_blocks() const { return owned_blocks_; }

  /// Reference weights and gradients of a cell, with the quadratic mapping of its 27 nodes.
  CellQuadrature quadrature(std::uint32_t cell) const;

  /// Writes a state as DIR/name.vtu, one file for all ranks: points at rest, nodal displacement, body and `cell_values`
  /// (one per cell of the mesh; those of owned cells are used). Collective; the directory exists.
  void write_vtu(const std::string &directory, const std::string &name, const State &state,
                 const std::vector<double> &cell_values, const std::string &value_name) const;

private:
  struct DealII;
  const Mesh &mesh_;
  MPI_Comm comm_;
  std::unique_ptr<DealII> deal_;
  std::vector<std::uint32_t> owned_cells_;
  std::vector<bool> owned_;
  std::vector<int> block_;
  std::pair<int, int> owned_blocks_;
};

/// Nodes of a face in lexicographic order; (d x/d xi) x (d x/d eta) points out of the cell.
std::array<Node, n_face_nodes> face_nodes(const Mesh &mesh, Face face);

/// Shape functions of the 9-node face at its Gauss points.
const FaceBasis &face_basis();

/// Faces of a named surface; throws std::invalid_argument that lists the known ones.
const std::vector<Face> &faces_of(const Mesh &mesh, const std::string &surface);

/// Nodes of a named surface, ascending.
std::vector<Node> surface_nodes(const Mesh &mesh, const std::string &surface);

/// Nodes of a named set; throws std::invalid_argument that lists the known ones.
const std::vector<Node> &nodes_of_set(const Mesh &mesh, const std::string &set);

/// Nodes of a place that is named as a surface or as a set of nodes, the other name being empty. Throws
/// std::invalid_argument for an unknown name, both names or none.
std::vector<Node> nodes_of_place(const Mesh &mesh, const std::string &surface, const std::string &set);

} // namespace ballonet::solver
