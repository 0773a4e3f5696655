// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "config/nearest_name.hpp"
#include "experiment/mixtures.hpp"

namespace tolman::experiment {
namespace {

/// Whether runs that differ in this factor alone have different results.
bool hasEffect(const std::vector<RunRow>& rows, const std::string& factor) {
  std::map<std::string, std::set<std::string>> results;
  for (const RunRow& row : rows) results[row.labelsWithout({factor})].insert(row.results);
  return std::ranges::any_of(results, [](const auto& of) { return of.second.size() > 1; });
}

bool varies(const std::vector<RunRow>& rows, const std::string& factor) {
  return std::ranges::any_of(
      rows, [&](const RunRow& row) { return row.label(factor) != rows.front().label(factor); });
}

}  // namespace

std::vector<std::string> factorsWithoutEffect(const std::vector<RunRow>& rows) {
  std::vector<std::string> names;
  if (rows.empty()) return names;
  for (const Factor& factor : rows.front().factors) {
    if (factor.name == "seed" || factor.name == "sequence") continue;
    if (varies(rows, factor.name) && !hasEffect(rows, factor.name)) names.push_back(factor.name);
  }
  return names;
}

std::string fewSamplesNote(std::size_t sequences, std::size_t seeds) {
  constexpr double kSignificant = 0.05;
  const std::size_t samples = sequences > 1 ? sequences : seeds;
  const double least = std::min(1.0, 2 * std::pow(0.5, static_cast<double>(samples)));
  if (least < kSignificant) return "";
  return fmt::format(
      "With {} p cannot be below {:.3g}, and the intervals of so few are too narrow: six sequences "
      "that all agree give 0.031.",
      sequences > 1 ? fmt::format("{} sequences", sequences)
                    : fmt::format("one sequence and {} seeds", seeds),
      least);
}

std::string sameTruthNote(const std::vector<RunRow>& rows) {
  std::map<std::string, std::set<std::string>> sequences;  // by true path
  for (const RunRow& row : rows) {
    if (!row.truth.empty()) sequences[row.truth].insert(row.label("sequence"));
  }
  for (const auto& [truth, of] : sequences) {
    if (of.size() < 2) continue;
    std::vector<std::string> names;
    names.reserve(of.size());
    for (const std::string& name : of) names.push_back("'" + name + "'");
    return fmt::format(
        "Of one true path are the sequences {}. Intervals and p count them as independent, "
        "which drives over one path are not if they have the same images: leave all but one out "
        "with --only, unless they were recorded at different times.",
        config::listed(names));
  }
  return "";
}

std::string unevenRunsNote(const std::vector<std::string>& levels) {
  return fmt::format(
      "In {} sequences or seeds have different numbers of runs. Mean, median and sd weigh all runs "
      "equally, intervals and differences all sequences: the mean need not lie in its interval.",
      config::listed(levels));
}

std::vector<std::string> trackingNotes(const std::vector<RunRow>& rows) {
  std::vector<std::string> notes;
  std::vector<std::string> lost;
  std::vector<std::string> partial;
  double least = 1;
  double most = 0;
  for (const RunRow& row : rows) {
    const auto code = row.metrics.find("exit_code");
    constexpr double kLost = 6;
    if (code != row.metrics.end() && code->second != 0) {
      (code->second == kLost ? lost : partial)
          .push_back(code->second == kLost ? row.name
                                           : fmt::format("{} ({:g})", row.name, code->second));
    }
    const auto coverage = row.metrics.find("map.coverage");
    if (coverage == row.metrics.end()) continue;
    least = std::min(least, coverage->second);
    most = std::max(most, coverage->second);
  }
  if (!lost.empty()) {
    notes.push_back(fmt::format(
        "{} of {} runs ended with exit code 6, odometry was not tracking at their end: {}.",
        lost.size(), rows.size(), config::listed(lost)));
  }
  if (!partial.empty()) {
    notes.push_back(fmt::format(
        "{} of {} runs were interrupted or failed (exit code in brackets), and their figures are "
        "of the part that they drove: {}.",
        partial.size(), rows.size(), config::listed(partial)));
  }
  if (most - least > kSameCoverage) {
    notes.push_back(fmt::format(
        "The runs cover {:.1f} to {:.1f} % of their true paths: errors of the lower ones are of "
        "the part that was tracked.",
        100 * least, 100 * most));
  }
  return notes;
}

}  // namespace tolman::experiment
