// SPDX-License-Identifier: BSD-3-Clause
// Lines with bands in axes, under a legend.
#pragma once

#include <string>
#include <utility>
#include <vector>

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

}  // namespace tolman::experiment
