// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/mixtures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace tolman::experiment {
namespace {

constexpr double kSameCoverage = 0.02;  // share of the frames

Status mixed(const RunRow& a, const RunRow& b, const std::string& what) {
  return Status::invalidInput("'" + a.name + "' and '" + b.name + "' " + what);
}

double coverageOf(const RunRow& row) {
  const auto found = row.metrics.find("map.coverage");
  return found == row.metrics.end() ? 1 : found->second;
}

Status refuseMixture(const RunRow& same, const RunRow& row, bool mixed_coverage) {
  if (row.truth != same.truth) {
    return mixed(same, row,
                 "have different true poses; name the sequences in the sweep, or choose runs with "
                 "--only");
  }
  const double difference = coverageOf(row) - coverageOf(same);
  if (mixed_coverage || std::abs(difference) <= kSameCoverage) return Status::ok();
  return mixed(same, row,
               fmt::format("cover {:.1f} % and {:.1f} % of the truth, so that their errors are of "
                           "different paths; --mixed-coverage averages them all the same",
                           100 * coverageOf(same), 100 * coverageOf(row)));
}

}  // namespace

RunPointers pointersTo(const std::vector<RunRow>& rows) {
  RunPointers pointers;
  for (const RunRow& row : rows) pointers.push_back(&row);
  return pointers;
}

Status refuseMixtures(const RunPointers& runs, bool mixed_coverage) {
  std::map<std::string, const RunRow*> first;  // by sequence
  for (const RunRow* run : runs) {
    const RunRow& other = *runs.front();
    if (run->alignment != other.alignment) {
      return mixed(other, *run,
                   "are aligned by " + other.alignment + " and " + run->alignment +
                       ", whose errors are not to be averaged; set evaluation.alignment, or "
                       "choose runs with --only");
    }
    const RunRow& same = *first.try_emplace(run->label("sequence"), run).first->second;
    if (Status status = refuseMixture(same, *run, mixed_coverage); !status.isOk()) return status;
  }
  return Status::ok();
}

}  // namespace tolman::experiment
