// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/algorithm.h"
#include <algorithm>
#include <cctype>
#include <numeric>
#include <stdexcept>

namespace ballonet::optimize
{

namespace
{
/// Levenshtein distance: the number of letters to insert, remove or replace.
std::size_t edit_distance(const std::string &a, const std::string &b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, replaced});
    }
  }
  return row.back();
}

std::string bare_name(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name.rfind("NLOPT_", 0) == 0 ? name.substr(6) : name;
}

template <class Condition>
std::string names_where(Condition condition)
{
  std::string names;
  for (const Algorithm &algorithm : algorithms())
    if (condition(algorithm))
      names += (names.empty() ? "" : ", ") + algorithm.name;
  return names;
}
} // namespace

const std::vector<Algorithm> &algorithms()
{
  using enum Constraints;
  static const std::vector<Algorithm> list = {
      {"LN_COBYLA", native},      {"LN_BOBYQA", augmented, 2},  {"LN_PRAXIS", augmented}, {"LN_NELDERMEAD", augmented},
      {"LN_SBPLX", augmented},    {"GN_DIRECT", refused},       {"GN_DIRECT_L", refused}, {"GN_DIRECT_L_RAND", refused},
      {"GN_ORIG_DIRECT", native}, {"GN_ORIG_DIRECT_L", native}, {"GN_CRS2_LM", refused},  {"GN_ISRES", native},
      {"GN_ESCH", refused},
  };
  return list;
}

const Algorithm &algorithm_named(const std::string &name)
{
  const std::string wanted = bare_name(name);
  const Algorithm *nearest = &algorithms().front();
  for (const Algorithm &algorithm : algorithms()) {
    if (algorithm.name == wanted)
      return algorithm;
    if (edit_distance(wanted, algorithm.name) < edit_distance(wanted, nearest->name))
      nearest = &algorithm;
  }
  throw std::invalid_argument("unknown algorithm '" + name + "'; did you mean " + nearest->name +
                              "? Allowed: " + names_where([](const Algorithm &) { return true; }));
}

void check(const Algorithm &algorithm, std::size_t n_variables, std::size_t n_constraints)
{
  if (n_constraints > 0 && algorithm.constraints == Constraints::refused)
    throw std::invalid_argument(
        algorithm.name + " takes no constraints; global algorithms that do: " + names_where([](const Algorithm &a) {
          return a.is_global() && a.constraints == Constraints::native;
        }));
  if (n_variables < algorithm.min_variables)
    throw std::invalid_argument(algorithm.name + " needs at least " + std::to_string(algorithm.min_variables) +
                                " continuous variables; these can do with " + std::to_string(n_variables) + ": " +
                                names_where([&](const Algorithm &a) { return n_variables >= a.min_variables; }));
}

} // namespace ballonet::optimize
