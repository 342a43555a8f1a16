// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/parameters.h"
#include <catch2/catch.hpp>
#include <set>

using namespace ballonet::geometry;

namespace
{

/// Visits a field list the way the readers of study files do.
class FieldCheck
{
public:
  void quantity(const std::string &key, const double &value, const std::string &unit, double low, double high,
                const std::string &help)
  {
    note(key, help);
    CHECK_FALSE(unit.empty());
    CHECK(low <= value);
    CHECK(value <= high);
  }
  void quantities(const std::string &key, const std::vector<double> &values, const std::string &unit, double low,
                  double high, const std::string &help)
  {
    note(key, help);
    for (const double value : values)
      quantity(key + "[]" + std::to_string(keys_.size()), value, unit, low, high, help);
  }
  void count(const std::string &key, const int &value, int low, int high, const std::string &help)
  {
    note(key, help);
    CHECK(low <= value);
    CHECK(value <= high);
  }
  void flag(const std::string &key, const bool &, const std::string &help) { note(key, help); }
  template <class Group>
  void group(const std::string &key, const Group &group, const std::string &help)
  {
    note(key, help);
    FieldCheck inside;
    Group::fields(group, inside);
    CHECK_FALSE(inside.keys_.empty());
  }

  std::size_t size() const { return keys_.size(); }

private:
  void note(const std::string &key, const std::string &help)
  {
    INFO(key);
    CHECK(keys_.insert(key).second);
    CHECK_FALSE(help.empty());
  }
  std::set<std::string> keys_;
};

template <class Parameters>
std::size_t checked_fields()
{
  const Parameters parameters;
  FieldCheck check;
  Parameters::fields(parameters, check);
  return check.size();
}

} // namespace

TEST_CASE("every field has a key of its own, a help text and a default within its range")
{
  CHECK(checked_fields<Pebs>() == 6);
  CHECK(checked_fields<Ribs>() == 10);
  CHECK(checked_fields<Wall>() == 6); // five fields and the one value of the list of rises
  CHECK(checked_fields<BalloonAlone>() == 2);
  CHECK(checked_fields<MeshSizes>() == 16);
}
