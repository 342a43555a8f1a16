// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include <array>
#include <map>
#include <string>
#include <string_view>

namespace ballonet::optimize
{

/// How an evaluation ended. Everything but ok is a failure: a value with a reason, never an exception.
enum class Status {
  ok,
  mesh_failed, ///< no valid mesh of this design
  diverged,    ///< no equilibrium found at the smallest step
  inverted,    ///< an element turned inside out
  step_limit,  ///< too many steps
  time_limit,  ///< too much wall time
  failed       ///< anything else; see the reason
};

/// Every status with the word that stands for it in journals and summaries.
constexpr std::array<std::pair<Status, std::string_view>, 7> status_words = {{
    {Status::ok, "ok"},
    {Status::mesh_failed, "mesh_failed"},
    {Status::diverged, "diverged"},
    {Status::inverted, "inverted"},
    {Status::step_limit, "step_limit"},
    {Status::time_limit, "time_limit"},
    {Status::failed, "failed"},
}};

/// The word of a status.
std::string_view word_of(Status status);

/// The status of a word. Throws std::invalid_argument if there is none.
Status status_of(std::string_view word);

/// What is known of one design once its computation has ended.
struct Evaluation {
  std::string hash;                        ///< of the resolved inputs: the identity of the evaluation
  Design design;                           ///< as asked
  Status status = Status::failed;          ///< how it ended
  std::string reason;                      ///< why it failed, empty if ok
  std::map<std::string, double> responses; ///< by name, in the units of the study; may be partial after a failure
  double seconds = 0;                      ///< wall time of the computation
  bool replayed = false;                   ///< answered from the journal of an earlier run; not part of the record
};

} // namespace ballonet::optimize
