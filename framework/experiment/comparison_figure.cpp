// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison_figure.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "report/axes.hpp"

namespace tolman::experiment {
namespace {

using report::Axes;
using report::Svg;

constexpr double kWidth = 520;  // px; scales to the column of a paper
constexpr double kHeight = 360;
constexpr std::array kColours = {report::kBlue,   report::kVermilion, report::kGreen,
                                 report::kOrange, report::kPurple,    report::kGrey};
constexpr std::array kPale = {"#cfe3f1", "#f6dccb", "#cbeadf", "#f9e9c8", "#f3dfe9", "#e8e8e8"};

struct LinePoint {
  double x = 0;
  double mean = 0;
  Interval band;
};
using Lines = std::map<std::string, std::vector<LinePoint>>;

/// Lines by the labels of the other factors; empty where a first label is no number.
Lines linesOf(const Comparison& comparison) {
  Lines lines;
  for (const Level& level : comparison.levels) {
    char* end = nullptr;
    const double x = std::strtod(level.label.c_str(), &end);
    if (end == level.label.c_str() || (*end != '\0' && *end != ',')) return {};
    const std::string rest = *end == ',' ? std::string(end + 2) : "";
    const double mean = level.summary.mean;
    lines[rest].push_back({x, mean, level.interval.value_or(Interval{mean, mean})});
  }
  for (auto& [name, points] : lines) std::ranges::sort(points, {}, &LinePoint::x);
  return lines;
}

report::Range rangeOf(double low, double high) {
  const double margin = 0.05 * (high - low) + 1e-9;
  return {low > 0 && low < 0.5 * high ? 0 : low - margin, high + margin};
}

report::AxesPlan planOf(const Comparison& comparison, report::Range x, report::Range y) {
  return {"", comparison.by.empty() ? "run" : comparison.by.front(), comparison.metric, x,
          y,  report::frame(80, 40, kWidth - 15, kHeight - 60)};
}

/// Between the lower and the upper border, in steps of a pixel.
void band(Svg& svg, const Axes& axes, const std::vector<LinePoint>& points, const char* colour) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double left = axes.at(points[i - 1].x, 0).x();
    const double right = axes.at(points[i].x, 0).x();
    for (double px = left; px < right; px += 1) {
      const double share = (px - left) / (right - left);
      const auto between = [&](double a, double b) { return a + share * (b - a); };
      const double low = between(points[i - 1].band.low, points[i].band.low);
      const double high = between(points[i - 1].band.high, points[i].band.high);
      const double top = axes.at(0, high).y();
      svg.rectangle({px, top}, {std::min(1.2, right - px), axes.at(0, low).y() - top}, colour);
    }
  }
}

std::string sensitivity(const Comparison& comparison, const Lines& lines) {
  report::Range x{lines.begin()->second.front().x, lines.begin()->second.front().x};
  double low = lines.begin()->second.front().mean;
  double high = low;
  for (const auto& [name, points] : lines) {
    for (const LinePoint& point : points) {
      x.include(point.x);
      low = std::min({low, point.mean, point.band.low});
      high = std::max({high, point.mean, point.band.high});
    }
  }
  Svg svg(kWidth, kHeight);
  Axes axes(svg, planOf(comparison, x, rangeOf(low, high)));
  std::vector<Axes::Entry> entries;
  std::size_t i = 0;
  for (const auto& [name, points] : lines) band(svg, axes, points, kPale[i++ % kPale.size()]);
  for (const auto& [name, points] : lines) {
    const char* colour = kColours[entries.size() % kColours.size()];
    std::vector<double> xs;
    std::vector<double> ys;
    for (const LinePoint& point : points) {
      xs.push_back(point.x);
      ys.push_back(point.mean);
      svg.circle(axes.at(point.x, point.mean), 3, colour);
    }
    axes.polyline(xs, ys, colour, 2);
    entries.push_back({colour, name});
  }
  if (entries.size() > 1) axes.legend(entries);
  return svg.take();
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
    // Spread by the golden ratio, so that dots of equal values are seen.
    const double golden = 0.6180339887498949 * static_cast<double>(i);
    const double dx = 0.4 * (golden - static_cast<double>(static_cast<std::int64_t>(golden)) - 0.5);
    svg.circle(axes.at(x + dx, level.values[i]), 2, colour);
  }
}

std::string boxes(const Comparison& comparison) {
  double low = comparison.levels.front().summary.low;
  double high = low;
  for (const Level& level : comparison.levels) {
    low = std::min(low, level.summary.low);
    high = std::max(high, level.summary.high);
  }
  const auto count = static_cast<double>(comparison.levels.size());
  Svg svg(kWidth, kHeight);
  // Levels are named below instead of numbered.
  report::AxesPlan plan = planOf(comparison, {0.4, count + 0.6}, rangeOf(low, high));
  plan.x_label = "";
  Axes axes(svg, plan);
  const double foot = plan.place.max().y();
  svg.rectangle({plan.place.min().x() - 10, foot + 1}, {plan.place.sizes().x() + 20, 40},
                report::kPaper);
  for (std::size_t i = 0; i < comparison.levels.size(); ++i) {
    const Level& level = comparison.levels[i];
    const double x = static_cast<double>(i) + 1;
    box(svg, axes, level, x, kColours[i % kColours.size()]);
    svg.text({axes.at(x, 0).x(), foot + (i % 2 == 0 ? 16 : 30)}, level.label,
             {report::TextAnchor::Middle, 10});
  }
  svg.text({plan.place.center().x(), foot + 48},
           comparison.by.empty() ? "run" : comparison.by.front(), {report::TextAnchor::Middle, 12});
  return svg.take();
}

}  // namespace

std::string comparisonFigure(const Comparison& comparison) {
  const Lines lines = linesOf(comparison);
  const bool has_line =
      std::ranges::any_of(lines, [](const auto& l) { return l.second.size() > 1; });
  return has_line ? sensitivity(comparison, lines) : boxes(comparison);
}

}  // namespace tolman::experiment
