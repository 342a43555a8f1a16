// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/parameters.h"
#include <functional>

namespace ballonet::tests
{

/// A problem with a known answer that two programs solve on the same mesh with the same parameters.
struct BenchmarkCase {
  solver::Mesh mesh;
  solver::Parameters parameters;
  /// Error of a displacement field (three values per node, mm), relative to the size of the known answer. Looks at
  /// corner and edge nodes only, which a 20-node hexahedron has too.
  std::function<double(const std::vector<double> &displacement)> error;
};

/// One of the cases of tests/verification under dead or follower loads:
///   tube, sphere  thick incompressible neo-Hookean wall (bulk modulus 1e6 mu) under the pressure of V / V0 = 3; error
///                 of the displacement, root of the mean square over the nodes
///   cook          Cook's membrane; error of the tip's vertical displacement
///   cantilever    slender beam, P L^2 / (E I) = 4; error of the tip's displacement against Euler's elastica
/// `cells`: number of cells through the wall, along a side, along the beam. Throws std::invalid_argument for other
/// names.
BenchmarkCase benchmark_case(const std::string &name, int cells);

/// Corner and edge nodes of the mesh, ascending.
std::vector<std::uint32_t> shared_nodes(const solver::Mesh &);

} // namespace ballonet::tests
