// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/repeated_rows.hpp"

#include <fmt/format.h>

#include <set>

namespace tolman::experiment {
namespace {

using Labels = std::set<std::pair<std::string, std::string>>;

Labels labelsOf(const RunRow& row) {
  Labels labels;
  for (const Factor& factor : row.factors) labels.emplace(factor.name, factor.label);
  return labels;
}

/// Compares results byte for byte, or without digests the metrics except times.
bool sameResults(const RunRow& a, const RunRow& b) {
  if (!a.results.empty() || !b.results.empty()) return a.results == b.results;
  const auto figures = [](const RunRow& row) {
    std::map<std::string, double> all = row.metrics;
    std::erase_if(all, [](const auto& metric) { return isTime(metric.first); });
    return all;
  };
  return figures(a) == figures(b);
}

}  // namespace

Status oneSetting(const RunRow& a, const RunRow& b) {
  return Status::invalidInput("'" + a.name + "' (" + a.directory.string() + ") and '" + b.name +
                              "' (" + b.directory.string() +
                              ") are of one setting, with the same factors and seed, and have "
                              "different results; leave one of them out");
}

Result<std::string> mergeRepeats(std::vector<RunRow>& rows) {
  std::map<Labels, std::size_t> first;
  std::vector<RunRow> kept;
  for (RunRow& row : rows) {
    const auto [same, is_new] = first.try_emplace(labelsOf(row), kept.size());
    if (is_new) {
      kept.push_back(std::move(row));
    } else if (!sameResults(kept[same->second], row)) {
      return oneSetting(kept[same->second], row);
    }
  }
  const std::size_t repeated = rows.size() - kept.size();
  rows = std::move(kept);
  if (repeated == 0) return std::string();
  return fmt::format(
      "{} of {} runs were given twice: another of the same factors and seed has the same results. "
      "They count once.",
      repeated, rows.size() + repeated);
}

}  // namespace tolman::experiment
