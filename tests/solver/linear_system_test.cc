// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/elastic_work.h"
#include "solver/linear_system.h"
#include "solver/petsc_call.h"
#include "tests/support/box_mesh.h"
#include "tests/support/derivative_check.h"

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// A spring of given stiffness between two nodes, in all directions; on the first rank only.
class Spring : public VirtualWork
{
public:
  Spring(Node a, Node b, double stiffness, bool mine) : nodes_{a, b}, stiffness_(stiffness), mine_(mine) {}
  void add_couplings(std::vector<std::vector<Node>> &sets) const override
  {
    if (mine_)
      sets.push_back(nodes_);
  }
  double energy(const State &) const override { return 0; }
  void residual(const State &, Assembly &) const override {}
  void tangent(const State &, Assembly &out) const override
  {
    if (!mine_)
      return;
    std::vector<double> K(36, 0.);
    for (int d = 0; d < 3; ++d) {
      K[6 * d + d] = K[6 * (d + 3) + d + 3] = stiffness_;
      K[6 * d + d + 3] = K[6 * (d + 3) + d] = -stiffness_;
    }
    out.add_tangent(nodes_, K);
  }

private:
  std::vector<Node> nodes_;
  double stiffness_;
  bool mine_;
};

Material plastic(double poisson_ratio)
{
  Material m;
  m.law = Law::saint_venant, m.youngs_modulus = 3, m.poisson_ratio = poisson_ratio;
  return m;
}

struct Block {
  Mesh mesh = box_mesh(3, 2, 2);
  Discretization discretization;
  ElasticWork elastic;
  State rest;
  explicit Block(MPI_Comm comm, double poisson_ratio = 0.3)
      : discretization(mesh, comm), elastic(discretization, 0, make_material(plastic(poisson_ratio)), 0, false)
  {
    rest.displacement.assign(3 * mesh.nodes.size(), 0.);
    elastic.begin_step(rest, {.dt = 1});
  }
};

} // namespace

TEST_CASE("linear system: solves what was assembled, on any number of ranks", "[mpi]")
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  Block shared(MPI_COMM_WORLD), whole(MPI_COMM_SELF);
  const Node far = shared.mesh.nodes.size() - 1;
  const Spring spring(0, far, 1.5, rank == 0), whole_spring(0, far, 1.5, true);
  DenseAssembly dense(shared.mesh.nodes.size());
  whole.elastic.tangent(whole.rest, dense);
  whole_spring.tangent(whole.rest, dense);

  const std::size_t n = dense.residual.size();
  Prescribed held(n, std::nan(""));
  std::vector<double> expected = random_field(n, 1, 4);
  for (const auto node : surface_nodes(shared.mesh, "x0"))
    for (int d = 0; d < 3; ++d)
      held[3 * node + d] = 0.1 * d;
  for (std::size_t i = 0; i < n; ++i)
    if (!std::isnan(held[i]))
      expected[i] = -held[i]; // the increment of a held value: u - prescribed, with u = 0
  const auto forces = product(dense, expected);

  LinearSystem system(shared.discretization);
  system.prescribe(held);
  std::vector<std::vector<Node>> couplings;
  spring.add_couplings(couplings);
  system.couple(couplings);
  auto spring_copy = spring;
  REQUIRE(system.factorise({&shared.elastic, &spring_copy}, shared.rest));
  CHECK(system.negative_pivots() == 0);
  Vec b = system.create_vector(), x = system.create_vector();
  system.scatter(forces, b);
  CHECK(system.hold(shared.rest, b) == Approx(0.2));
  system.solve_held(b, x);
  std::vector<double> solution(n), back(n);
  system.gather(x, solution);
  double worst = 0;
  for (std::size_t i = 0; i < n; ++i)
    worst = std::max(worst, std::abs(solution[i] - expected[i]));
  INFO("largest error " << worst);
  CHECK(worst < 1e-11);

  system.scatter(expected, b);
  system.gather(b, back);
  CHECK(back == expected);
  CHECK(system.clear_held(b) == Approx(std::sqrt(surface_nodes(shared.mesh, "x0").size() * 0.05)));
  petsc(VecDestroy(&b));
  petsc(VecDestroy(&x));
}

TEST_CASE("linear system: negative pivots count the unstable directions", "[mpi]")
{
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  Block block(MPI_COMM_WORLD);
  LinearSystem system(block.discretization);
  Prescribed held(3 * block.mesh.nodes.size(), std::nan(""));
  for (const auto node : surface_nodes(block.mesh, "x0"))
    std::fill_n(&held[3 * node], 3, 0.);
  system.prescribe(held);
  // a negative spring stronger than the block pulls one of its corners away from a held node, in three directions
  const Node corner = block.mesh.nodes.size() - 1;
  Spring repelling(0, corner, -50, rank == 0);
  std::vector<std::vector<Node>> couplings;
  repelling.add_couplings(couplings);
  system.couple(couplings);
  REQUIRE(system.factorise({&block.elastic, &repelling}, block.rest));
  CHECK(system.negative_pivots() == 3);
}

TEST_CASE("linear system: the factor of another matrix preconditions, and is renewed where it is too far off", "[mpi]")
{
  Block block(MPI_COMM_WORLD), like(MPI_COMM_WORLD, 0.32), unlike(MPI_COMM_WORLD, 0.4999), whole(MPI_COMM_SELF, 0.32),
      whole_unlike(MPI_COMM_SELF, 0.4999);
  LinearSystem system(block.discretization);
  const std::size_t n = 3 * block.mesh.nodes.size();
  Prescribed held(n, std::nan(""));
  std::vector<double> expected = random_field(n, 1, 4);
  for (const auto node : surface_nodes(block.mesh, "x0"))
    for (std::size_t i = 3 * node; i < 3 * node + 3; ++i)
      held[i] = expected[i] = 0;
  system.prescribe(held);
  REQUIRE(system.factorise({&block.elastic}, block.rest));
  Vec b = system.create_vector(), x = system.create_vector();
  const auto error = [&](Block &other, Block &entire) {
    DenseAssembly dense(block.mesh.nodes.size());
    entire.elastic.tangent(entire.rest, dense);
    system.scatter(product(dense, expected), b);
    system.clear_held(b);
    system.precondition({&other.elastic}, other.rest);
    system.solve(b, x);
    std::vector<double> solution(n);
    system.gather(x, solution);
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i)
      worst = std::max(worst, std::abs(solution[i] - expected[i]));
    return worst;
  };
  const double iterated = error(like, whole);
  CHECK(iterated < 1e-3);
  CHECK(iterated > 1e-9); // not solved by a factor of its own
  CHECK(system.factorisations() == 1);
  CHECK(error(unlike, whole_unlike) < 1e-8);
  CHECK(system.factorisations() == 2);
  petsc(VecDestroy(&b));
  petsc(VecDestroy(&x));
}
