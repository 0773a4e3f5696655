// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison_figure.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

#include "experiment/path_lines.hpp"
#include "report/axes.hpp"

namespace tolman::experiment {

namespace {

using report::Axes;
using report::Svg;

constexpr std::array kColours = {report::kBlue,   report::kVermilion, report::kGreen,
                                 report::kOrange, report::kPurple,    report::kGrey};
constexpr std::array kPale = {"#cfe3f1", "#f6dccb", "#cbeadf", "#f9e9c8", "#f3dfe9", "#e8e8e8"};

constexpr double kLegendLine = 14;  // px
constexpr double kLetter = 6;       // px, of the legend

const char* colourOf(const std::vector<Line>& lines, std::size_t i) {
  return lines[i].colour != nullptr ? lines[i].colour : lineColour(i);
}

/// Names in one or more lines, from the upper border.
class Legend {
 public:
  explicit Legend(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      const double width = 34 + kLetter * static_cast<double>(line.name.size());
      if (x_ > kLeft && x_ + width > kFigureWidth) {
        x_ = kLeft;
        y_ += kLegendLine;
      }
      places_.emplace_back(x_, y_);
      x_ += width;
    }
  }
  double height() const { return y_ + 8; }
  void draw(Svg& svg, const std::vector<Line>& lines) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Eigen::Vector2d& at = places_[i];
      svg.line(at - Eigen::Vector2d(0, 4), at + Eigen::Vector2d(16, -4), colourOf(lines, i), 3);
      svg.text(at + Eigen::Vector2d(20, 0), lines[i].name, {report::TextAnchor::Start, 11});
    }
  }

 private:
  static constexpr double kLeft = 12;
  double x_ = kLeft;
  double y_ = 14;
  std::vector<Eigen::Vector2d> places_;
};

/// Fills the band between its lower and upper border, in steps of a pixel.
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
      const double height = axes.at(0, low).y() - top;
      if (height > 0) svg.rectangle({px, top}, {std::min(1.2, right - px), height}, colour);
    }
  }
}

void draw(Svg& svg, Axes& axes, const Line& line, const char* colour, bool dots) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const LinePoint& point : line.points) {
    xs.push_back(point.x);
    ys.push_back(point.y);
    if (dots) svg.circle(axes.at(point.x, point.y), 3, colour);
  }
  axes.polyline(xs, ys, colour, dots ? 2 : 1.5);
  // Draws the borders of the band, because another band may cover it.
  std::vector<double> lows;
  std::vector<double> highs;
  for (const LinePoint& point : line.points) {
    if (point.band.low == point.band.high) return;
    lows.push_back(point.band.low);
    highs.push_back(point.band.high);
  }
  axes.polyline(xs, lows, colour, 0.6);
  axes.polyline(xs, highs, colour, 0.6);
}

}  // namespace

const char* lineColour(std::size_t i) { return kColours[i % kColours.size()]; }

report::Range figureRange(double low, double high) {
  const double margin = 0.05 * (high - low) + 1e-9;
  return {low >= 0 && low < 0.5 * high ? 0 : low - margin, high + margin};
}

std::string lineFigure(const LineFigure& figure) {
  const LinePoint& first = figure.lines.front().points.front();
  report::Range x{first.x, first.x};
  report::Range y{first.y, first.y};
  for (const Line& line : figure.lines) {
    for (const LinePoint& point : line.points) {
      x.include(point.x);
      y.include(point.y);
      if (point.band.low == point.band.high) continue;
      y.include(point.band.low);
      y.include(point.band.high);
    }
  }
  const bool several = figure.lines.size() > 1;
  const Legend legend(several ? figure.lines : std::vector<Line>());
  Svg svg(kFigureWidth, kFigureHeight);
  Axes axes(
      svg,
      {"", figure.x_label, figure.y_label, x, figure.equal ? y : figureRange(y.low, y.high),
       report::frame(64, legend.height(), kFigureWidth - 12, kFigureHeight - 44), figure.equal});
  for (std::size_t i = 0; i < figure.lines.size(); ++i) {
    band(svg, axes, figure.lines[i].points, kPale[i % kPale.size()]);
  }
  for (std::size_t i = 0; i < figure.lines.size(); ++i) {
    draw(svg, axes, figure.lines[i], colourOf(figure.lines, i), figure.dots);
  }
  if (several) legend.draw(svg, figure.lines);
  return svg.take();
}

namespace {

using report::Axes;
using report::Svg;

/// One line for each combination of the other factors; none if a first label is not a number.
std::vector<Line> linesOf(const Comparison& comparison) {
  std::map<std::string, std::vector<LinePoint>> lines;
  for (const Level& level : comparison.levels) {
    char* end = nullptr;
    const double x = std::strtod(level.label.c_str(), &end);
    if (end == level.label.c_str() || (*end != '\0' && *end != ',')) return {};
    const double mean = level.summary.mean;
    lines[*end == ',' ? end + 2 : ""].push_back(
        {x, mean, level.interval.value_or(Interval{mean, mean})});
  }
  std::vector<Line> sorted;
  for (auto& [name, points] : lines) {
    std::ranges::sort(points, {}, &LinePoint::x);
    sorted.push_back({name, std::move(points), nullptr});
  }
  return sorted;
}

std::string factorName(const Comparison& comparison) {
  return comparison.by.empty() ? "run" : comparison.by.front();
}

/// The metric in the words of an axis, with its unit; other metrics keep their names.
std::string axisLabel(const std::string& metric) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kLabels = {{
      {".ate.rmse_m", "ATE OF, RMSE (m)"},
      {".ate_horizontal.rmse_m", "horizontal ATE OF, RMSE (m)"},
      {".ate_vertical.rmse_m", "vertical ATE OF, RMSE (m)"},
      {".kitti.t_rel_percent", "translation error OF (%)"},
      {".kitti.r_rel_deg_per_100m", "rotation error OF (degrees per 100 m)"},
  }};
  const bool of_map = metric.starts_with("map.");
  if (!of_map && !metric.starts_with("odometry.")) return metric;
  for (const auto& [end, label] : kLabels) {
    if (metric.substr(metric.find('.')) != end) continue;
    std::string text(label);
    return text.replace(text.find("OF"), 2, of_map ? "of the map" : "of odometry");
  }
  return metric;
}

/// Step functions: at each value of the metric one more run is within the limit.
std::vector<Line> successLines(const Comparison& comparison) {
  double most = 0;
  for (const Level& level : comparison.levels) most = std::max(most, level.summary.high);
  std::vector<Line> lines;
  for (const Level& level : comparison.levels) {
    std::vector<double> sorted = level.values;
    std::ranges::sort(sorted);
    Line line{level.label, {{0, 0, {}}}, nullptr};
    for (const double value : sorted) {
      const double before = line.points.back().y;
      line.points.push_back({value, before, {}});
      line.points.push_back({value, before + 100 / static_cast<double>(sorted.size()), {}});
    }
    line.points.push_back({most, 100, {}});
    lines.push_back(std::move(line));
  }
  return lines;
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
  double low = comparison.levels.front().summary.low;
  double high = low;
  for (const Level& level : comparison.levels) {
    low = std::min(low, level.summary.low);
    high = std::max(high, level.summary.high);
  }
  const auto count = static_cast<double>(comparison.levels.size());
  Svg svg(kFigureWidth, kFigureHeight);
  // The level names below replace the numbers of the x axis.
  Axes axes(svg, {"",
                  "",
                  axisLabel(comparison.metric),
                  {0.4, count + 0.6},
                  figureRange(low, high),
                  report::frame(64, 12, kFigureWidth - 12, kFigureHeight - 60)});
  const Eigen::AlignedBox2d& place = axes.box();
  const double foot = place.max().y();
  svg.rectangle({place.min().x() - 10, foot + 1}, {place.sizes().x() + 20, 40}, report::kPaper);
  for (std::size_t i = 0; i < comparison.levels.size(); ++i) {
    const Level& level = comparison.levels[i];
    const double x = static_cast<double>(i) + 1;
    box(svg, axes, level, x, lineColour(i));
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
  auto lines = maps ? mapLines(comparison) : errorLines(comparison);
  if (!lines.isOk()) return lines.status();
  if (maps) return lineFigure({"x (m)", "y (m)", std::move(lines).value(), false, true});
  return lineFigure({"driven path (m)", "position error (m)", std::move(lines).value()});
}

}  // namespace

Result<std::string> comparisonFigure(const Comparison& comparison, FigureKind kind) {
  if (kind == FigureKind::Maps || kind == FigureKind::Distance) return pathFigure(comparison, kind);
  if (kind == FigureKind::Success) {
    return lineFigure(
        {"limit: " + axisLabel(comparison.metric), "runs within (%)", successLines(comparison)});
  }
  std::vector<Line> lines = kind == FigureKind::Box ? std::vector<Line>() : linesOf(comparison);
  const bool has_line =
      std::ranges::any_of(lines, [](const Line& line) { return line.points.size() > 1; });
  if (has_line) {
    return lineFigure(
        {factorName(comparison), axisLabel(comparison.metric), std::move(lines), true});
  }
  if (kind != FigureKind::Line) return boxes(comparison);
  return Status::invalidParameter("no line can be drawn over '" + factorName(comparison) +
                                  "', whose labels are not all numbers, or only one");
}

}  // namespace tolman::experiment
