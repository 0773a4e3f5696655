// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>

#include "config/text.hpp"
#include "evaluation/alignment.hpp"
#include "evaluation/errors.hpp"
#include "experiment/comparison_figure.hpp"
#include "record/run_reader.hpp"

namespace tolman::experiment {
namespace {

using report::Curve;

constexpr std::size_t kParts = 100;  // equal parts of the path

/// The map transformed into the coordinates of the truth.
Result<evaluation::Matches> alignedMap(const std::filesystem::path& directory,
                                       const std::string& alignment) {
  const auto reader = record::RunReader::open(directory);
  if (!reader.isOk()) return reader.status();
  const auto truth = reader.value()->truth();
  const auto& map = reader.value()->map();
  if (!truth.isOk()) return truth.status();
  if (!map.isOk()) return map.status();
  const auto matches = evaluation::associateByFrame(truth.value(), map.value());
  if (!matches.isOk()) return matches.status();
  const auto kind = config::valueNamed<evaluation::Alignment>(alignment);
  const auto similarity =
      evaluation::align(matches.value(), kind.value_or(evaluation::Alignment::Se3));
  if (!similarity.isOk()) return similarity.status();
  return evaluation::aligned(matches.value(), similarity.value());
}

/// Mean error in each part of the path, m; for a part without frames that of the part before.
std::vector<double> errorsByPart(const evaluation::Matches& matches, bool planar) {
  const auto driven = evaluation::distances(matches.truth);
  const auto errors = evaluation::positionErrors(
      matches, planar ? evaluation::Direction::Horizontal : evaluation::Direction::All);
  std::vector<double> sums(kParts, 0);
  std::vector<double> counts(kParts, 0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double share = driven[i] / std::max(driven.back(), 1e-9);
    const auto part = std::min(kParts - 1, static_cast<std::size_t>(share * kParts));
    sums[part] += errors[i];
    counts[part] += 1;
  }
  for (std::size_t i = 0; i < kParts; ++i) {
    sums[i] = counts[i] > 0 ? sums[i] / counts[i] : i > 0 ? sums[i - 1] : 0;
  }
  return sums;
}

Result<Curve> errorCurve(const Level& level, const std::string& alignment) {
  std::vector<std::vector<double>> parts(kParts);  // errors of the runs
  double length = 0;
  for (const auto& directory : level.directories) {
    const auto matches = alignedMap(directory, alignment);
    if (!matches.isOk()) return matches.status();
    length = evaluation::pathLength(matches.value().truth);
    const auto errors = errorsByPart(matches.value(), alignment == "se2");
    for (std::size_t i = 0; i < kParts; ++i) parts[i].push_back(errors[i]);
  }
  Curve curve{level.label, nullptr, {}, {}};
  for (std::size_t i = 0; i < kParts; ++i) {
    std::ranges::sort(parts[i]);
    curve.x.push_back(length * (static_cast<double>(i) + 0.5) / kParts);
    curve.y.push_back(summaryOf(parts[i]).mean);
    curve.low.push_back(quantile(parts[i], 0.25));
    curve.high.push_back(quantile(parts[i], 0.75));
  }
  return curve;
}

Curve curveOf(std::string name, const char* colour, const evaluation::Trajectory& trajectory) {
  Curve curve{std::move(name), colour, {}, {}};
  for (const auto& pose : trajectory) {
    curve.x.push_back(pose.T_world_camera.translation().x());
    curve.y.push_back(pose.T_world_camera.translation().z());
  }
  return curve;
}

const std::filesystem::path& medianRun(const Level& level) {
  std::vector<std::size_t> order(level.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return level.values[i]; });
  return level.directories[order[(order.size() - 1) / 2]];
}

}  // namespace

Result<std::vector<Curve>> errorCurves(const Comparison& comparison) {
  std::vector<Curve> curves;
  for (const Level& level : comparison.levels) {
    auto curve = errorCurve(level, comparison.alignment);
    if (!curve.isOk()) return curve.status();
    curve.value().colour = report::lineColour(curves.size());
    curves.push_back(std::move(curve).value());
  }
  return curves;
}

Result<std::vector<Curve>> mapCurves(const Comparison& comparison) {
  std::vector<Curve> curves;
  for (const Level& level : comparison.levels) {
    const auto matches = alignedMap(medianRun(level), comparison.alignment);
    if (!matches.isOk()) return matches.status();
    curves.push_back(
        curveOf(level.label, report::lineColour(curves.size()), matches.value().estimate));
    if (curves.size() < comparison.levels.size()) continue;
    curves.push_back(curveOf("truth", report::kGrey, matches.value().truth));
  }
  return curves;
}

}  // namespace tolman::experiment
