// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison_figure.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

namespace tolman::experiment {
namespace {

using report::Axes;
using report::Curve;
using report::Svg;

constexpr double kWidth = 360;  // px
constexpr double kHeight = 270;

std::string curveFigure(const std::string& x_label, const std::string& y_label,
                        std::vector<Curve> curves, bool equal = false) {
  if (curves.size() == 1) curves[0].name.clear();
  const double right = kWidth - 12;
  constexpr double kLeft = 64;
  const double top = Axes::legendHeight(report::legendOf(curves), right - kLeft);
  Svg svg(kWidth, kHeight);
  report::plot(svg,
               {"", x_label, y_label, report::Range::none(), report::Range::none(),
                report::frame(kLeft, top, right, kHeight - 44), equal},
               curves);
  return svg.take();
}

/// One curve for each combination of the other factors; none if a first label is not a number.
std::vector<Curve> linesOf(const Comparison& comparison) {
  std::map<std::string, std::map<double, const Level*>> lines;
  for (const Level& level : comparison.levels) {
    char* end = nullptr;
    const double x = std::strtod(level.label.c_str(), &end);
    if (end == level.label.c_str() || (*end != '\0' && *end != ',')) return {};
    lines[*end == ',' ? end + 2 : ""][x] = &level;
  }
  std::vector<Curve> curves;
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
std::vector<Curve> successCurves(const Comparison& comparison) {
  double most = 0;
  for (const Level& level : comparison.levels) most = std::max(most, level.summary.high);
  std::vector<Curve> curves;
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
    const double dx = 0.4 * (golden - static_cast<double>(static_cast<std::int64_t>(golden)) - 0.5);
    svg.circle(axes.at(x + dx, level.values[i]), 2, colour);
  }
}

std::string boxes(const Comparison& comparison) {
  Curve values{"", report::kGrey, {}, {}};  // without x: only for the range
  for (const Level& level : comparison.levels) {
    values.y.insert(values.y.end(), level.values.begin(), level.values.end());
  }
  Svg svg(kWidth, kHeight);
  const Axes axes = report::plot(svg,
                                 {"",
                                  "",
                                  axisLabel(comparison.metric),
                                  {0.4, static_cast<double>(comparison.levels.size()) + 0.6},
                                  report::Range::none(),
                                  report::frame(64, 12, kWidth - 12, kHeight - 60)},
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

Result<std::string> pathFigure(const Comparison& comparison, FigureKind kind) {
  if (comparison.truths > 1) {
    return Status::invalidParameter("the figure '" + std::string(enumName(kind)) +
                                    "' is of one true path: choose one with --only "
                                    "sequence=LABEL");
  }
  const bool maps = kind == FigureKind::Maps;
  auto curves = maps ? mapCurves(comparison) : errorCurves(comparison);
  if (!curves.isOk()) return curves.status();
  return curveFigure(maps ? "x (m)" : "driven path (m)", maps ? "y (m)" : "position error (m)",
                     std::move(curves).value(), maps);
}

}  // namespace

Result<std::string> comparisonFigure(const Comparison& comparison, FigureKind kind) {
  if (kind == FigureKind::Maps || kind == FigureKind::Distance) return pathFigure(comparison, kind);
  const std::string metric = axisLabel(comparison.metric);
  if (kind == FigureKind::Success) {
    return curveFigure("limit: " + metric, "runs within (%)", successCurves(comparison));
  }
  const std::vector<Curve> lines =
      kind == FigureKind::Box ? std::vector<Curve>() : linesOf(comparison);
  const bool has_line =
      std::ranges::any_of(lines, [](const Curve& line) { return line.x.size() > 1; });
  if (has_line) return curveFigure(factorName(comparison), metric, lines);
  if (kind != FigureKind::Line) return boxes(comparison);
  return Status::invalidParameter("no line can be drawn over '" + factorName(comparison) +
                                  "', whose labels are not all numbers, or only one");
}

}  // namespace tolman::experiment
