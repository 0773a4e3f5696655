// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/mixtures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tolman::experiment {
namespace {

Status mixed(const RunRow& a, const RunRow& b, const std::string& what) {
  return Status::invalidInput("'" + a.name + "' and '" + b.name + "' " + what);
}

double coverageOf(const RunRow& row) {
  const auto found = row.metrics.find("map.coverage");
  return found == row.metrics.end() ? 1 : found->second;
}

/// The segment lengths of a drift such as "map.kitti.t_rel_percent", m.
std::vector<double> lengthsOf(const RunRow& row, const std::string& metric) {
  const std::string prefix = metric.substr(0, metric.rfind('.')) + ".lengths_m.";
  std::vector<double> lengths;
  for (auto found = row.metrics.lower_bound(prefix);
       found != row.metrics.end() && found->first.starts_with(prefix); ++found) {
    lengths.push_back(found->second);
  }
  std::ranges::sort(lengths);
  return lengths;
}

std::string lengthsText(const std::vector<double>& lengths) {
  if (lengths.empty()) return "unknown lengths";
  return fmt::format("{:g} to {:g} m", lengths.front(), lengths.back());
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
    if (coverageOf(*run) <= 0) {
      return Status::invalidInput(
          "'" + run->name +
          "' has not tracked a single frame of the truth, so that its errors are those of standing "
          "still; leave it out with --only");
    }
    const RunRow& same = *first.try_emplace(run->label("sequence"), run).first->second;
    if (Status status = refuseMixture(same, *run, mixed_coverage); !status.isOk()) return status;
  }
  return Status::ok();
}

Status refuseMixedLengths(const RunPointers& runs, const std::string& metric) {
  if (metric.find(".kitti.") == std::string::npos || runs.empty()) return Status::ok();
  const std::vector<double> lengths = lengthsOf(*runs.front(), metric);
  for (const RunRow* run : runs) {
    const std::vector<double> own = lengthsOf(*run, metric);
    if (own == lengths) continue;
    return mixed(*runs.front(), *run,
                 "have drifts over segments of " + lengthsText(lengths) + " and of " +
                     lengthsText(own) +
                     ", which are not to be averaged; set evaluation.segments, or choose runs "
                     "with --only");
  }
  return Status::ok();
}

Status refuseCopies(const RunPointers& runs) {
  std::map<std::string, std::map<std::string, std::string>> results;  // of a sequence, by the rest
  for (const RunRow* run : runs) {
    if (run->results.empty()) continue;
    results[run->label("sequence")][run->labelsWithout({"sequence"})] = run->results;
  }
  std::map<std::map<std::string, std::string>, std::string> first;
  for (const auto& [sequence, own] : results) {
    const auto [same, is_new] = first.try_emplace(own, sequence);
    if (is_new) continue;
    return Status::invalidInput(
        "the sequences '" + same->second + "' and '" + sequence +
        "' have the same results byte for byte: copies of one drive are not independent; leave "
        "one of them out with --only");
  }
  return Status::ok();
}

}  // namespace tolman::experiment
