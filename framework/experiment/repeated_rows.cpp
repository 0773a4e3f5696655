// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/repeated_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

/// The first metric except times that both have, with values that differ; empty if there is none.
std::string otherFigure(const RunRow& a, const RunRow& b) {
  constexpr double kSame = 1e-6;  // relative: digits that a table may have lost
  for (const auto& [metric, value] : a.metrics) {
    const auto other = b.metrics.find(metric);
    if (other == b.metrics.end() || isTime(metric)) continue;
    const double largest = std::max(std::abs(value), std::abs(other->second));
    if (std::abs(value - other->second) <= kSame * largest) continue;
    return fmt::format("{} of '{}' is {:.6g} ({}) and {:.6g} ({})", metric, a.name, value,
                       a.directory.string(), other->second, b.directory.string());
  }
  return "";
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
  std::string changed;
  std::size_t changes = 0;
  for (RunRow& row : rows) {
    const auto [same, is_new] = first.try_emplace(labelsOf(row), kept.size());
    if (is_new) {
      kept.push_back(std::move(row));
    } else if (!sameResults(kept[same->second], row)) {
      return oneSetting(kept[same->second], row);
    } else if (const std::string other = otherFigure(kept[same->second], row); !other.empty()) {
      if (changes++ == 0) changed = other;
    }
  }
  const std::size_t repeated = rows.size() - kept.size();
  rows = std::move(kept);
  if (repeated == 0) return std::string();
  const std::string note = fmt::format(
      "{} of {} runs were given twice: another of the same factors and seed has the same results. "
      "They count once.",
      repeated, rows.size() + repeated);
  if (changes == 0) return note;
  return note + fmt::format(
                    " {} of them have other figures in spite of the same digest of results ({}): "
                    "the first given counts; was a table edited, or scored by another version?",
                    changes, changed);
}

}  // namespace tolman::experiment
