// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/journal.h"
#include "studies/critical_record.h"
#include "studies/instability.h"
#include <map>
#include <string>

namespace ballonet::studies
{

/// Where an evaluation's files are, and which mesh it had.
struct Origin {
  int number = 0;        ///< of its folder evaluations/NNNN
  std::string mesh_hash; ///< empty if there was no mesh
};

/// Evaluations as lines of journal.jsonl: {"id", "hash", "design", "units", "status", "reason", "responses", "seconds",
/// "mesh_hash", "judgement", "critical_points"}. Numbers are written so that they read back bit by bit; a response that
/// is not finite is null. Evaluations without a judged path, and those of versions that did not judge, have no
/// "judgement"; those on whose path no critical point was located have no "critical_points".
class JournalFormat
{
public:
  explicit JournalFormat(optimize::DesignSpace space) : space_(std::move(space)) {}

  /// The origin must have been set.
  std::string write(const optimize::Evaluation &evaluation) const;

  /// Remembers origin and judgement. Throws std::invalid_argument if the line is no evaluation of this space.
  optimize::Evaluation read(const std::string &line);

  void set_origin(const std::string &hash, Origin origin) { origins_[hash] = std::move(origin); }
  const Origin &origin(const std::string &hash) const { return origins_.at(hash); }

  void set_judgement(const std::string &hash, Judgement judgement) { judgements_[hash] = std::move(judgement); }
  /// nullptr if there is none.
  const Judgement *judgement(const std::string &hash) const;

  void set_critical_points(const std::string &hash, std::vector<CriticalRecord> points)
  {
    critical_points_[hash] = std::move(points);
  }

  /// For optimize::Journal; this object must outlive it.
  optimize::LineFormat line_format();

private:
  optimize::DesignSpace space_;
  std::map<std::string, Origin> origins_;                              // by hash of the evaluation
  std::map<std::string, Judgement> judgements_;                        // likewise
  std::map<std::string, std::vector<CriticalRecord>> critical_points_; // likewise
};

} // namespace ballonet::studies
