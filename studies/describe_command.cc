// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/commands.h"
#include "studies/study_file.h"

namespace ballonet::studies
{
namespace
{

void print(std::ostream &out, const KeyDescription &row)
{
  out << row.key << "\n    " << row.help << "\n    " << row.type;
  if (!row.unit.empty() && row.unit != "1")
    out << " in " << row.unit;
  if (!row.range.empty())
    out << "; " << row.range;
  out << "; default: " << row.default_value << "\n";
}

} // namespace

ExitCode describe_command(const Invocation &invocation)
{
  std::vector<std::string> known;
  bool found = false;
  for (const KeyDescription &row : describe_all_keys()) {
    known.push_back(row.key);
    if (!row.key.starts_with(invocation.key))
      continue;
    print(invocation.out, row);
    found = true;
  }
  if (!found) {
    const std::string hint = nearest_hint(invocation.key, known);
    throw InputError({"describe"}, "", "\"" + invocation.key + "\"", "the beginning of a key",
                     hint.starts_with("nearest") ? hint : "without a key, all are described");
  }
  return done;
}

} // namespace ballonet::studies
