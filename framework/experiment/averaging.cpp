// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/averaging.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "config/text.hpp"

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

std::string LevelNames::nameOf(const RunRow& row, const std::vector<std::string>& by) {
  std::string name;
  for (const std::string& factor : by) {
    name += (&factor == &by.front() ? "" : ", ") + row.label(factor);
  }
  return name;
}

Status LevelNames::add(const RunRow& row, const std::vector<std::string>& by) {
  const std::string name = nameOf(row, by);
  const RunRow& same = *first_.try_emplace(name, &row).first->second;
  for (const std::string& factor : by) {
    if (same.label(factor) == row.label(factor)) continue;
    return Status::invalidInput("'" + same.name + "' and '" + row.name + "' differ in " + factor +
                                ", but both would be in the row '" + name +
                                "'; rename a label, or compare by one factor at a time");
  }
  return Status::ok();
}

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
