// SPDX-License-Identifier: BSD-3-Clause
// The axes of a plot, a box with ticks and labels; converts values to pixels.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "report/svg.hpp"

namespace tolman::report {

struct Range {
  /// Nothing; plot() extends it to its values.
  static constexpr Range none() { return {HUGE_VAL, -HUGE_VAL}; }
  double low = 0;
  double high = 1;
  void include(double value);
  double length() const { return high - low; }
};

/// About `wanted` round values within the range: multiples of 1, 2 or 5 times a power of ten.
std::vector<double> ticks(const Range& range, int wanted);
/// A value with as many decimals as the step of the axis needs: "0.25", "1500".
std::string tickText(double value, double step);

/// The box of the axes in the picture, px.
inline Eigen::AlignedBox2d frame(double left, double top, double right, double bottom) {
  return {Eigen::Vector2d(left, top), Eigen::Vector2d(right, bottom)};
}

struct AxesPlan {
  std::string title;
  std::string x_label;  ///< with its unit
  std::string y_label;  ///< empty: also no ticks
  Range x;
  Range y;
  Eigen::AlignedBox2d place;  ///< the box, px
  bool equal = false;         ///< equal scales; the box is made smaller to fit
};

class Axes {
 public:
  /// Draws box, grid lines, ticks and labels.
  Axes(Svg& svg, AxesPlan plan);

  Eigen::Vector2d at(double x, double y) const;
  double pixelsX(double length) const { return length * scale_.x(); }
  const Eigen::AlignedBox2d& box() const { return plan_.place; }
  /// Values outside the box are clamped to it.
  void polyline(const std::vector<double>& x, const std::vector<double>& y, const char* colour,
                double thickness = 1.5);

  struct LegendEntry {
    const char* colour;
    std::string name;
  };
  /// Draws a legend above the box, from the left, in as many lines as it needs.
  void legend(const std::vector<LegendEntry>& entries);

 private:
  void fit();
  void draw(bool vertical);
  Svg& svg_;
  AxesPlan plan_;
  Eigen::Vector2d scale_;  ///< px per unit
};

struct Curve {
  std::string name;  ///< in the legend
  const char* colour;
  std::vector<double> x;
  std::vector<double> y;
  double thickness = 1.5;
  bool dots = false;  ///< at each point
  // The borders of a band around the curve; empty: none.
  std::vector<double> low{};
  std::vector<double> high{};
};

/// Draws curves in axes whose ranges are extended to all values; a range of y that was none() gets
/// a margin, and begins at 0 where that is near. A legend where the curves have names.
Axes plot(Svg& svg, AxesPlan plan, const std::vector<Curve>& curves);

/// The whole picture: curves in axes whose place is chosen, with their legend above. `size` in px.
std::string curveFigure(AxesPlan plan, const std::vector<Curve>& curves,
                        const Eigen::Vector2d& size);

}  // namespace tolman::report
