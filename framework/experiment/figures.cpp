// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "base/must.hpp"
#include "experiment/comparison.hpp"
#include "report/axes.hpp"

namespace tolman::experiment {
namespace {

using report::Curve;
using Curves = std::vector<Curve>;

const Eigen::Vector2d kSize(360, 270);  // px

/// One curve for each combination of the other factors; none if a first label is not a number.
Curves linesOf(const Comparison& comparison) {
  std::map<std::string, std::map<double, const Level*>> lines;
  for (const Level& level : comparison.levels) {
    const auto number = leadingNumber(level.label);
    if (!number) return {};
    lines[number->second][number->first] = &level;
  }
  Curves curves;
  for (const auto& [name, levels] : lines) {
    Curve& curve = curves.emplace_back(Curve{name, report::lineColour(curves.size()), {}, {}});
    curve.dots = true;
    for (const auto& [x, level] : levels) {
      const double mean = level->summary.mean;
      const Interval interval = level->interval.value_or(Interval{mean, mean});
      curve.x.push_back(x);
      curve.y.push_back(mean);
      curve.low.push_back(interval.low);
      curve.high.push_back(interval.high);
    }
  }
  return curves;
}

/// A curve for each level at its place in the list: a dot for each run, joined from the lowest to
/// the highest.
Curves columnsOf(const Comparison& comparison) {
  Curves curves;
  for (const Level& level : comparison.levels) {
    std::vector<double> sorted = level.values;
    std::ranges::sort(sorted);
    const std::vector<double> x(sorted.size(), static_cast<double>(curves.size() + 1));
    curves.push_back({level.label, report::lineColour(curves.size()), x, sorted, 1.5, true});
  }
  return curves;
}

/// Seen from above, x right and y forward in m.
Curve pathCurve(std::string name, const char* colour, const evaluation::Trajectory& trajectory) {
  const Eigen::Matrix3Xd points = evaluation::positions(trajectory);
  const auto row = [&](Eigen::Index i) {
    const Eigen::VectorXd values = points.row(i);
    return std::vector<double>(values.begin(), values.end());
  };
  return {std::move(name), colour, row(0), row(2)};
}

const std::filesystem::path& medianRun(const Level& level) {
  std::vector<std::size_t> order(level.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return level.values[i]; });
  return level.directories[order[(order.size() - 1) / 2]];
}

}  // namespace

std::string levelsFigure(const Comparison& comparison) {
  const Curves lines = linesOf(comparison);
  const bool has_line =
      std::ranges::any_of(lines, [](const Curve& line) { return line.x.size() > 1; });
  const std::string factor = comparison.by.empty() ? "run" : comparison.by.front();
  const auto free = report::Range::none();
  return report::curveFigure({"", factor, comparison.metric, free, free, {}},
                             has_line ? lines : columnsOf(comparison), kSize);
}

Result<std::string> mapsFigure(const Comparison& comparison) {
  return resultOf([&] {
    if (comparison.truths > 1) {
      must(Status::invalidParameter(
          "the figure 'maps' is of one true path: choose one with --only sequence=LABEL"));
    }
    Curves curves;
    evaluation::Trajectory truth;
    for (const Level& level : comparison.levels) {
      const auto matches = alignedMap(medianRun(level), comparison.alignment);
      curves.push_back(pathCurve(level.label, report::lineColour(curves.size()), matches.estimate));
      truth = matches.truth;
    }
    curves.push_back(pathCurve("truth", report::kGrey, truth));
    const auto free = report::Range::none();
    return report::curveFigure({"", "x (m)", "y (m)", free, free, {}, true}, curves, kSize);
  });
}

}  // namespace tolman::experiment
