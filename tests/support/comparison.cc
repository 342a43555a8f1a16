// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <mpi.h>

namespace ballonet::tests
{

namespace
{

void write_line(std::ostream &out, const Comparison &c)
{
  const char *kinds[] = {"relative", "absolute", "at_least"};
  out << std::setprecision(10) << "{\"what\": " << std::quoted(c.what) << ", \"source\": " << std::quoted(c.source)
      << ", \"kind\": \"" << kinds[static_cast<int>(c.kind)] << "\", \"unit\": " << std::quoted(c.unit)
      << ", \"expected\": " << c.expected << ", \"measured\": " << c.measured << ", \"error\": " << c.error()
      << ", \"tolerance\": " << c.tolerance << ", \"holds\": " << (c.holds() ? "true" : "false") << "}\n";
}

} // namespace

double Comparison::error() const { return kind == Kind::relative ? measured / expected - 1 : measured - expected; }

bool Comparison::holds() const
{
  return std::isfinite(measured) && (kind == Kind::at_least ? measured >= expected : std::abs(error()) <= tolerance);
}

void compare(const Comparison &c)
{
  INFO(c.what << ": measured " << c.measured << ", expected " << c.expected << " " << c.unit << ", error " << c.error()
              << ", tolerance " << c.tolerance);
  CHECK(c.holds());
  int rank;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (const char *file = std::getenv("BALLONET_VERIFICATION_OUT"); file && rank == 0) {
    std::ofstream out(file, std::ios::app);
    write_line(out, c);
  }
}

} // namespace ballonet::tests
