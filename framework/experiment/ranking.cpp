// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/must.hpp"
#include "config/text.hpp"
#include "record/run_reader.hpp"

namespace tolman::experiment {
namespace {

constexpr std::size_t kStretches = 20;  // of the path; chosen, not tuned
constexpr std::uint64_t kSeed = 1;      // of the bootstrap
constexpr const char* kError = "map.ate.rmse_m";

double root(double square) { return std::sqrt(std::max(square, 0.0)); }

/// A run and its mean squared error in each part of the path, m^2.
struct Measured {
  Ranked ranked;
  std::vector<double> squares;
};

Measured measured(const RunRow& run) {
  Measured result{{&run, run.metrics.at(kError)},
                  errorsByPart(alignedMap(run.directory, run.alignment), kStretches,
                               run.alignment == "se2", Moment::Square)};
  const Interval square = bootstrapMean({result.squares}, kSeed);
  result.ranked.interval = {root(square.low), root(square.high)};
  return result;
}

bool isAsGood(const Measured& run, const Measured& best) {
  std::vector<double> worse;
  for (std::size_t i = 0; i < std::min(run.squares.size(), best.squares.size()); ++i) {
    worse.push_back(run.squares[i] - best.squares[i]);
  }
  return bootstrapMean({worse}, kSeed).low <= 0;
}

std::string countOf(const RunRow& run, const std::string& key) {
  const auto found = run.metrics.find(key);
  return found == run.metrics.end() ? "-" : fmt::format("{:.0f}", found->second);
}

}  // namespace

evaluation::Matches alignedMap(const std::filesystem::path& run, const std::string& alignment) {
  const auto reader = must(record::RunReader::open(run));
  const auto matches =
      must(evaluation::associateByFrame(must(reader->truth()), must(reader->map())));
  const auto kind = config::valueNamed<evaluation::Alignment>(alignment);
  return evaluation::aligned(
      matches, must(evaluation::align(matches, kind.value_or(evaluation::Alignment::Se3))));
}

std::vector<double> errorsByPart(const evaluation::Matches& matches, std::size_t parts, bool planar,
                                 Moment moment) {
  const auto driven = evaluation::distances(matches.truth);
  const auto errors = evaluation::positionErrors(
      matches, planar ? evaluation::Direction::Horizontal : evaluation::Direction::All);
  std::vector<double> sums(parts, 0);
  std::vector<double> counts(parts, 0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double share = driven[i] / std::max(driven.back(), 1e-9);
    const auto part =
        std::min(parts - 1, static_cast<std::size_t>(share * static_cast<double>(parts)));
    sums[part] += moment == Moment::Square ? errors[i] * errors[i] : errors[i];
    counts[part] += 1;
  }
  for (std::size_t i = 0; i < parts; ++i) {
    sums[i] = counts[i] > 0 ? sums[i] / counts[i] : i > 0 ? sums[i - 1] : 0;
  }
  return sums;
}

Result<std::vector<Ranked>> rankedRuns(const std::vector<RunRow>& rows) {
  return resultOf([&] {
    std::vector<Measured> runs;
    for (const RunRow& row : rows) {
      if (row.metrics.contains(kError)) runs.push_back(measured(row));
    }
    std::ranges::stable_sort(runs, {}, [](const Measured& run) { return run.ranked.rmse_m; });
    std::vector<Ranked> ranked;
    for (Measured& run : runs) {
      run.ranked.as_good = isAsGood(run, runs.front());
      ranked.push_back(run.ranked);
    }
    return ranked;
  });
}

Table tableOf(const std::vector<Ranked>& ranked, const std::vector<RunRow>& rows) {
  Table table;
  const std::vector<std::string> factors = factorNames(rows);
  table.heading = factors;
  for (const char* name : {"map m", "95 %", "as good", "loops", "false"}) {
    table.heading.emplace_back(name);
  }
  const auto add = [&](const RunRow& run, const Ranked* error) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    for (const std::string& factor : factors) cells.push_back(run.label(factor));
    cells.push_back(error == nullptr ? "-" : fmt::format("{:.3g}", error->rmse_m));
    cells.push_back(error == nullptr ? "-"
                                     : fmt::format("{:.3g} to {:.3g}", error->interval.low,
                                                   error->interval.high));
    cells.emplace_back(error != nullptr && error->as_good ? "yes" : "");
    cells.push_back(countOf(run, "loop_links"));
    cells.push_back(countOf(run, "loops.false_links"));
  };
  for (const Ranked& run : ranked) add(*run.run, &run);
  for (const RunRow& row : rows) {
    if (!row.metrics.contains(kError)) add(row, nullptr);
  }
  return table;
}

}  // namespace tolman::experiment
