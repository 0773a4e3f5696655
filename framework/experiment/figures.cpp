// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/figures.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "base/must.hpp"
#include "config/text.hpp"
#include "experiment/ranking.hpp"

namespace tolman::experiment {
namespace {

using evaluation::quantile;
using report::Axes;
using report::Curve;
using report::Svg;
using Curves = std::vector<Curve>;

const Eigen::Vector2d kSize(360, 270);  // px
constexpr std::size_t kParts = 100;     // equal parts of the path

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

std::string factorName(const Comparison& comparison) {
  return comparison.by.empty() ? "run" : comparison.by.front();
}

/// The metric in the words of an axis, with its unit; other metrics keep their names.
std::string axisLabel(const std::string& metric) {
  static const std::map<std::string, std::string> kLabels = {
      {".ate.rmse_m", "ATE OF, RMSE (m)"},
      {".ate_horizontal.rmse_m", "horizontal ATE OF, RMSE (m)"},
      {".ate_vertical.rmse_m", "vertical ATE OF, RMSE (m)"},
      {".kitti.t_rel_percent", "translation error OF (%)"},
      {".kitti.r_rel_deg_per_100m", "rotation error OF (degrees per 100 m)"}};
  const bool of_map = metric.starts_with("map.");
  if (!of_map && !metric.starts_with("odometry.")) return metric;
  const auto found = kLabels.find(metric.substr(metric.find('.')));
  if (found == kLabels.end()) return metric;
  std::string text = found->second;
  return text.replace(text.find("OF"), 2, of_map ? "of the map" : "of odometry");
}

/// Step functions: at each value of the metric one more run is within the limit.
Curves successCurves(const Comparison& comparison) {
  double most = 0;
  for (const Level& level : comparison.levels) most = std::max(most, level.summary.max);
  Curves curves;
  for (const Level& level : comparison.levels) {
    std::vector<double> sorted = level.values;
    std::ranges::sort(sorted);
    Curve curve{level.label, report::lineColour(curves.size()), {0}, {0}};
    for (const double value : sorted) {
      const double before = curve.y.back();
      curve.x.insert(curve.x.end(), 2, value);
      curve.y.insert(curve.y.end(), {before, before + 100 / static_cast<double>(sorted.size())});
    }
    curve.x.push_back(most);
    curve.y.push_back(100);
    curves.push_back(std::move(curve));
  }
  return curves;
}

void box(Svg& svg, const Axes& axes, const Level& level, double x, const char* colour) {
  std::vector<double> sorted = level.values;
  std::ranges::sort(sorted);
  const auto at = [&](double dx, double share) { return axes.at(x + dx, quantile(sorted, share)); };
  svg.line(at(0, 0), at(0, 1), report::kFrameLine);
  const Eigen::Vector2d corner = at(-0.28, 0.75);
  svg.rectangle(corner, at(0.28, 0.25) - corner, report::kPaper, report::kFrameLine);
  svg.line(at(-0.28, 0.5), at(0.28, 0.5), report::kFrameLine, 2);
  for (std::size_t i = 0; i < level.values.size(); ++i) {
    // Shifted by the golden ratio, so that dots of equal values do not overlap.
    const double golden = 0.6180339887498949 * static_cast<double>(i);
    svg.circle(axes.at(x + 0.4 * (golden - std::floor(golden) - 0.5), level.values[i]), 2, colour);
  }
}

std::string boxes(const Comparison& comparison) {
  Curve values{"", report::kGrey, {}, {}};  // without x: only for the range
  for (const Level& level : comparison.levels) {
    values.y.insert(values.y.end(), level.values.begin(), level.values.end());
  }
  Svg svg(kSize.x(), kSize.y());
  const Axes axes = report::plot(svg,
                                 {"",
                                  "",
                                  axisLabel(comparison.metric),
                                  {0.4, static_cast<double>(comparison.levels.size()) + 0.6},
                                  report::Range::none(),
                                  report::frame(64, 12, kSize.x() - 12, kSize.y() - 60)},
                                 {values});
  const Eigen::AlignedBox2d& place = axes.box();
  const double foot = place.max().y();
  // The names of the levels replace the numbers of the x axis.
  svg.rectangle({place.min().x() - 10, foot + 1}, {place.sizes().x() + 20, 40}, report::kPaper);
  for (std::size_t i = 0; i < comparison.levels.size(); ++i) {
    const Level& level = comparison.levels[i];
    const double x = static_cast<double>(i) + 1;
    box(svg, axes, level, x, report::lineColour(i));
    svg.text({axes.at(x, 0).x(), foot + (i % 2 == 0 ? 16 : 30)}, level.label,
             {report::TextAnchor::Middle, 10});
  }
  svg.text({place.center().x(), foot + 48}, factorName(comparison),
           {report::TextAnchor::Middle, 12});
  return svg.take();
}

/// The position error (m) of the runs over the driven path (m): mean, and quartiles as a band.
Curve errorCurve(const Level& level, const std::string& alignment, const char* colour) {
  std::vector<std::vector<double>> parts(kParts);  // errors of the runs
  double length = 0;
  for (const auto& directory : level.directories) {
    const auto matches = alignedMap(directory, alignment);
    length = evaluation::pathLength(matches.truth);
    const auto errors = errorsByPart(matches, kParts, alignment == "se2");
    for (std::size_t i = 0; i < kParts; ++i) parts[i].push_back(errors[i]);
  }
  Curve curve{level.label, colour, {}, {}};
  for (std::size_t i = 0; i < kParts; ++i) {
    std::ranges::sort(parts[i]);
    curve.x.push_back(length * (static_cast<double>(i) + 0.5) / kParts);
    curve.y.push_back(evaluation::statistics(parts[i]).mean);
    curve.low.push_back(quantile(parts[i], 0.25));
    curve.high.push_back(quantile(parts[i], 0.75));
  }
  return curve;
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

/// Error or map of each level, from the records.
std::string pathFigure(const Comparison& comparison, FigureKind kind) {
  if (comparison.truths > 1) {
    must(Status::invalidParameter("the figure '" + std::string(enumName(kind)) +
                                  "' is of one true path: choose one with --only "
                                  "sequence=LABEL"));
  }
  const bool maps = kind == FigureKind::Maps;
  Curves curves;
  evaluation::Trajectory truth;
  for (const Level& level : comparison.levels) {
    const char* colour = report::lineColour(curves.size());
    if (maps) {
      const auto matches = alignedMap(medianRun(level), comparison.alignment);
      curves.push_back(pathCurve(level.label, colour, matches.estimate));
      truth = matches.truth;
    } else {
      curves.push_back(errorCurve(level, comparison.alignment, colour));
    }
  }
  if (maps) curves.push_back(pathCurve("truth", report::kGrey, truth));
  const auto free = report::Range::none();
  return report::curveFigure(
      maps ? report::AxesPlan{"", "x (m)", "y (m)", free, free, {}, true}
           : report::AxesPlan{"", "driven path (m)", "position error (m)", free, free, {}},
      curves, kSize);
}

}  // namespace

Result<std::string> comparisonFigure(const Comparison& comparison, FigureKind kind) {
  if (kind == FigureKind::Maps || kind == FigureKind::Distance) {
    return resultOf([&] { return pathFigure(comparison, kind); });
  }
  const std::string metric = axisLabel(comparison.metric);
  const auto free = report::Range::none();
  if (kind == FigureKind::Success) {
    return report::curveFigure({"", "limit: " + metric, "runs within (%)", free, free, {}},
                               successCurves(comparison), kSize);
  }
  const Curves lines = kind == FigureKind::Box ? Curves() : linesOf(comparison);
  const bool has_line =
      std::ranges::any_of(lines, [](const Curve& line) { return line.x.size() > 1; });
  if (has_line) {
    return report::curveFigure({"", factorName(comparison), metric, free, free, {}}, lines, kSize);
  }
  if (kind != FigureKind::Line) return boxes(comparison);
  return Status::invalidParameter("no line can be drawn over '" + factorName(comparison) +
                                  "', whose labels are not all numbers, or only one");
}

}  // namespace tolman::experiment
