// SPDX-License-Identifier: BSD-3-Clause
// Lines with bands in axes, under a legend.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiment/comparison.hpp"
#include "experiment/statistics.hpp"
#include "report/axes.hpp"

namespace tolman::experiment {

struct LinePoint {
  double x = 0;
  double y = 0;
  Interval band;  ///< low == high: none
};

struct Line {
  std::string name;
  std::vector<LinePoint> points;
  const char* colour = nullptr;  ///< null: by its place among the lines
};

/// Size of all figures, px; 360 px are 88.9 mm, the column of a paper.
inline constexpr double kFigureWidth = 360;
inline constexpr double kFigureHeight = 270;

/// Colours of the lines and boxes, in their order.
const char* lineColour(std::size_t i);

struct LineFigure {
  std::string x_label;
  std::string y_label;
  std::vector<Line> lines;
  bool dots = false;   ///< at each point
  bool equal = false;  ///< equal scales
};

/// SVG. A legend where there are several lines.
std::string lineFigure(const LineFigure& figure);

/// The range of an axis: 5 % wider than the values; from 0 if they are near 0.
report::Range figureRange(double low, double high);

// Figures of a comparison, as wide as a column of a paper, in colours that colour-blind readers can
// distinguish (Okabe and Ito 2008).

enum class FigureKind : std::uint8_t {
  Auto,     ///< Line where the first factor is a number, else Box
  Line,     ///< mean over the first factor with its interval as a band, a line for each of the rest
  Box,      ///< quartiles, whiskers to all values, and a dot for each run
  Success,  ///< share of the runs whose metric is at most a limit, over that limit
  Distance,  ///< position error over the driven path: mean of the runs, quartiles as a band
  Maps,      ///< the true path, and the map of the median run of each level
};
inline constexpr std::array<std::string_view, 6> kFigureKindNames = {"auto",    "line",     "box",
                                                                     "success", "distance", "maps"};
constexpr std::span<const std::string_view> enumNames(FigureKind) { return kFigureKindNames; }

/// SVG. Distance and Maps open the records of the runs, and need a single true path.
/// InvalidParameter for several true paths, and for Line if the labels are not numbers.
Result<std::string> comparisonFigure(const Comparison& comparison,
                                     FigureKind kind = FigureKind::Auto);

}  // namespace tolman::experiment
