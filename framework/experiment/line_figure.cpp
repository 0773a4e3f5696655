// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/line_figure.hpp"

#include <algorithm>
#include <array>

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

}  // namespace tolman::experiment
