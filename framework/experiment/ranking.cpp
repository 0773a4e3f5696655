// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/must.hpp"
#include "config/text.hpp"
#include "experiment/comparison.hpp"
#include "record/run_reader.hpp"

namespace tolman::experiment {
namespace {

constexpr std::size_t kStretches = 20;  // of the path; chosen, not tuned
constexpr std::uint64_t kSeed = 1;      // of the bootstrap
constexpr const char* kError = "map.ate.rmse_m";

double root(double square) { return std::sqrt(std::max(square, 0.0)); }

/// Mean squared position error (m^2) in each of equal parts of the true path; for a part without
/// frames that of the part before.
std::vector<double> squaresByPart(const RunRow& run) {
  const evaluation::Matches matches = alignedMap(run.directory, run.alignment);
  const auto driven = evaluation::distances(matches.truth);
  const auto errors =
      evaluation::positionErrors(matches, run.alignment == "se2" ? evaluation::Direction::Horizontal
                                                                 : evaluation::Direction::All);
  std::array<std::vector<double>, kStretches> parts;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double share = driven[i] / std::max(driven.back(), 1e-9);
    const auto part = static_cast<std::size_t>(share * static_cast<double>(kStretches));
    parts.at(std::min(kStretches - 1, part)).push_back(errors[i] * errors[i]);
  }
  std::vector<double> squares;
  for (const std::vector<double>& part : parts) {
    squares.push_back(!part.empty()     ? evaluation::statistics(part).mean
                      : squares.empty() ? 0
                                        : squares.back());
  }
  return squares;
}

/// A run and its squaresByPart().
struct Measured {
  Ranked ranked;
  std::vector<double> squares;
};

Measured measured(const RunRow& run) {
  Measured result{{&run, run.metrics.at(kError)}, squaresByPart(run)};
  const Interval square = bootstrapMean({result.squares}, kSeed);
  result.ranked.interval = {root(square.low), root(square.high)};
  return result;
}

bool isAsGood(const Measured& run, const Measured& best) {
  std::vector<double> worse;
  for (std::size_t i = 0; i < kStretches; ++i) {
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
