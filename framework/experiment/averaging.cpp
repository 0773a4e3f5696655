// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/must.hpp"
#include "config/text.hpp"
#include "experiment/comparison.hpp"
#include "tolman/context.hpp"

namespace tolman::experiment {

namespace {

constexpr double kSameCoverage = 0.02;  // share of the frames

double coverageOf(const RunRow& row) {
  const auto found = row.metrics.find("map.coverage");
  return found == row.metrics.end() ? 1 : found->second;
}

/// The segment lengths of a drift such as "map.kitti.t_rel_percent", m; empty for other metrics.
std::vector<double> lengthsOf(const RunRow& row, const std::string& metric) {
  std::vector<double> lengths;
  if (metric.find(".kitti.") == std::string::npos) return lengths;
  const std::string prefix = metric.substr(0, metric.rfind('.')) + ".lengths_m.";
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

/// Results byte for byte, or without digests the metrics except times.
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

void refuseMixtures(const RunPointers& runs, const std::vector<std::string>& metrics) {
  const RunRow& first = *runs.front();
  std::map<std::string, const RunRow*> of_sequence;
  for (const RunRow* run : runs) {
    const auto mixed = [&](const RunRow& with, const std::string& what) {
      throw Refused{Status::invalidInput("'" + with.name + "' and '" + run->name + "' " + what)};
    };
    if (run->alignment != first.alignment) {
      mixed(first, "are aligned by " + first.alignment + " and " + run->alignment +
                       ", whose errors are not to be averaged; set evaluation.alignment, or "
                       "choose runs with --only");
    }
    const double coverage = coverageOf(*run);
    if (coverage <= 0) {
      must(Status::invalidInput(
          "'" + run->name +
          "' has not tracked a single frame of the truth, so that its errors are those of standing "
          "still; leave it out with --only"));
    }
    const RunRow& same = *of_sequence.try_emplace(run->label("sequence"), run).first->second;
    if (run->truth != same.truth) {
      mixed(same,
            "have different true poses; name the sequences in the sweep, or choose runs with "
            "--only");
    }
    if (std::abs(coverage - coverageOf(same)) > kSameCoverage) {
      mixed(same, fmt::format("cover {:.1f} % and {:.1f} % of the truth, so that their errors are "
                              "of different paths; leave one out with --only",
                              100 * coverageOf(same), 100 * coverage));
    }
    for (const std::string& metric : metrics) {
      const auto lengths = lengthsOf(first, metric), own = lengthsOf(*run, metric);
      if (own == lengths) continue;
      mixed(first, "have drifts over segments of " + lengthsText(lengths) + " and of " +
                       lengthsText(own) +
                       ", which are not to be averaged; set evaluation.segments, or choose runs "
                       "with --only");
    }
  }
}

void refuseSetting(const RunRow& a, const RunRow& b) {
  throw Refused{Status::invalidInput(
      "'" + a.name + "' (" + a.directory.string() + ") and '" + b.name + "' (" +
      b.directory.string() +
      ") are of one setting, with the same factors and seed, and have different results; leave one "
      "of them out")};
}

std::string mergeRepeats(std::vector<RunRow>& rows) {
  std::map<std::string, std::size_t> first;  // by setting
  std::vector<RunRow> kept;
  for (RunRow& row : rows) {
    const auto [same, is_new] = first.try_emplace(row.labelsWithout({}), kept.size());
    if (!is_new && !sameResults(kept[same->second], row)) refuseSetting(kept[same->second], row);
    if (is_new) kept.push_back(std::move(row));
  }
  const std::size_t repeated = rows.size() - kept.size();
  rows = std::move(kept);
  if (repeated == 0) return "";
  return fmt::format(
      "{} of {} runs were given twice: another of the same factors and seed has the same results. "
      "They count once.",
      repeated, rows.size() + repeated);
}

std::string levelName(const RunRow& row, const std::vector<std::string>& by) {
  std::string name;
  for (const std::string& factor : by) {
    name += (&factor == &by.front() ? "" : ", ") + row.label(factor);
  }
  return name;
}

std::vector<std::string> trackingNotes(const std::vector<RunRow>& rows) {
  constexpr double kLost = 6;  // exit code
  std::vector<std::string> notes, lost, partial;
  double least = 1, most = 0;
  for (const RunRow& row : rows) {
    const auto code = row.metrics.find("exit_code");
    if (code != row.metrics.end() && code->second == kLost) {
      lost.push_back(row.name);
    } else if (code != row.metrics.end() && code->second != 0) {
      partial.push_back(fmt::format("{} ({:g})", row.name, code->second));
    }
    if (!row.metrics.contains("map.coverage")) continue;
    least = std::min(least, coverageOf(row));
    most = std::max(most, coverageOf(row));
  }
  const auto note = [&](const std::vector<std::string>& names, const char* what) {
    if (names.empty()) return;
    notes.push_back(fmt::format("{} of {} runs {}: {}.", names.size(), rows.size(), what,
                                config::listed(names)));
  };
  note(lost, "ended with exit code 6, odometry was not tracking at their end");
  note(partial,
       "were interrupted or failed (exit code in brackets), and their figures are of the part that "
       "they drove");
  if (most - least > kSameCoverage) {
    notes.push_back(fmt::format(
        "The runs cover {:.1f} to {:.1f} % of their true paths: errors of the lower ones are of "
        "the part that was tracked.",
        100 * least, 100 * most));
  }
  return notes;
}

namespace {

using evaluation::quantile;

constexpr std::size_t kResamples = 10'000;

/// Twice the rank (from 1) of each value: equal values share their mean rank.
std::vector<std::size_t> doubleRanks(const std::vector<double>& sizes) {
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return sizes[i]; });
  std::vector<std::size_t> ranks(sizes.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && sizes[order[end]] == sizes[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = begin + 1 + end;
    begin = end;
  }
  return ranks;
}

/// The probability of each sum of a random choice of `steps`, each taken with probability 1/2.
std::vector<double> sumDistribution(const std::vector<std::size_t>& steps) {
  std::vector<double> probability = {1};
  for (const std::size_t step : steps) {
    std::vector<double> next(probability.size() + step, 0.0);
    for (std::size_t sum = 0; sum < probability.size(); ++sum) {
      next[sum] += probability[sum] / 2;
      next[sum + step] += probability[sum] / 2;
    }
    probability = std::move(next);
  }
  return probability;
}

}  // namespace

Interval bootstrapMean(const std::vector<std::vector<double>>& groups, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<double> means;
  means.reserve(kResamples);
  for (std::size_t i = 0; i < kResamples; ++i) {
    double sum = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const auto& group = groups.size() == 1 ? groups[0] : groups[random.below(groups.size())];
      double within = 0;
      for (std::size_t k = 0; k < group.size(); ++k) within += group[random.below(group.size())];
      sum += within / static_cast<double>(group.size());
    }
    means.push_back(sum / static_cast<double>(groups.size()));
  }
  std::ranges::sort(means);
  return {quantile(means, 0.025), quantile(means, 0.975)};
}

SignedRank signedRank(const std::vector<double>& differences) {
  std::vector<double> kept;
  for (const double d : differences) {
    if (d != 0) kept.push_back(d);
  }
  SignedRank result;
  result.n = kept.size();
  if (kept.empty()) return result;
  std::vector<double> sizes;
  for (const double d : kept) sizes.push_back(std::abs(d));
  const std::vector<std::size_t> ranks = doubleRanks(sizes);
  std::size_t positive = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) positive += kept[i] > 0 ? ranks[i] : 0;
  const std::vector<double> probability = sumDistribution(ranks);
  const std::size_t all = probability.size() - 1;
  const std::size_t smaller = std::min(positive, all - positive);
  double tail = 0;
  for (std::size_t sum = 0; sum <= smaller; ++sum) tail += probability[sum];
  result.p = std::min(1.0, 2 * tail);
  result.effect =
      (2.0 * static_cast<double>(positive) - static_cast<double>(all)) / static_cast<double>(all);
  return result;
}

}  // namespace tolman::experiment
