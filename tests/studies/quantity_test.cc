// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/quantity.h"
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

using namespace ballonet::studies;

TEST_CASE("quantities of every kind become internal units")
{
  struct Row {
    const char *text, *unit;
    double value;
  };
  const Row rows[] = {
      {"7.2 mm", "mm", 7.2},
      {"0.72 cm", "mm", 7.2},
      {"160 kPa", "MPa", 0.16},
      {"1.6e5 Pa", "MPa", 0.16},
      {"1 bar", "MPa", 0.1},
      {"80 deg", "deg", 80},
      {"-40 deg", "deg", -40},
      {"1080 kg/m^3", "t/mm^3", 1.08e-9},
      {"1.08 g/cm^3", "t/mm^3", 1.08e-9},
      {"9.81 m/s^2", "mm/s^2", 9810},
      {"5.2e-4 1/MPa", "1/MPa", 5.2e-4},
      {"5.2e-10 1/Pa", "1/MPa", 5.2e-4},
      {"80 kPa/s", "MPa/s", 0.08},
      {"9 MPa/mm", "MPa/mm", 9},
      {"5 ms", "s", 0.005},
      {"2 min", "s", 120},
      {"6 1/s", "1/s", 6},
      {"6 Hz", "1/s", 6},
      {"3 N", "N", 3},
      {"+3N", "N", 3},
      {"  4   mm ", "mm", 4},
      {"0.3", "1", 0.3},
      {"1 N/mm^2", "MPa", 1},
  };
  for (const Row &row : rows) {
    CAPTURE(row.text);
    REQUIRE(parse_quantity(row.text, row.unit) == row.value); // bit by bit
  }
  REQUIRE(parse_quantity("3.141592653589793 rad", "deg") == Approx(180).epsilon(1e-14));
}

TEST_CASE("wrong quantities are refused with their reason")
{
  struct Row {
    const char *text, *unit, *reason;
  };
  const Row rows[] = {
      {"7.2", "mm", "the unit is missing"}, {"7.2 mm", "MPa", "\"mm\" measures something else"},
      {"7.2 foots", "mm", "unknown"},       {"nan mm", "mm", "finite"},
      {"inf mm", "mm", "finite"},           {"1e999 mm", "mm", "finite"},
      {"7.2 mm 3", "mm", "not a unit"},     {"7.2 mm;", "mm", "not a unit"},
      {"7,2 mm", "mm", "not a unit"},       {"mm", "mm", "a number with a unit"},
      {"", "mm", "a number with a unit"},   {"7.2 mm from 3", "mm", "not a unit"},
      {"0x10 mm", "mm", "unknown"},         {"7.2 mm^2", "mm", "something else"},
      {"1e305 km", "mm", "finite"},         {"three mm", "mm", "a number with a unit"},
  };
  for (const Row &row : rows) {
    CAPTURE(row.text);
    REQUIRE_THROWS_WITH(parse_quantity(row.text, row.unit), Catch::Contains(row.reason));
    REQUIRE_THROWS_AS(parse_quantity(row.text, row.unit), QuantityError);
  }
}

TEST_CASE("a written quantity is read back bit by bit")
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-20, 20);
  for (int i = 0; i < 1000; ++i) {
    const double value = mantissa(random) * std::pow(10, exponent(random));
    REQUIRE(parse_quantity(format_quantity(value, "t/mm^3"), "t/mm^3") == value);
    REQUIRE(parse_quantity(format_quantity(value, "1"), "1") == value);
  }
  REQUIRE(format_quantity(0.16, "MPa") == "0.16 MPa");
  REQUIRE(format_quantity(7, "mm") == "7.0 mm");
  REQUIRE(format_quantity(-0.0, "1") == "-0.0");
}

TEST_CASE("quantities may be read by several threads at once")
{
  std::vector<std::thread> threads;
  std::atomic<int> wrong = 0;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&wrong] {
      for (int i = 0; i < 500; ++i)
        wrong += parse_quantity("1080 kg/m^3", "t/mm^3") != 1.08e-9;
    });
  for (auto &thread : threads)
    thread.join();
  REQUIRE(wrong == 0);
}
