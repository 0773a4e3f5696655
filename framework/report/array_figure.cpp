// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "report/axes.hpp"
#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/raster.hpp"

namespace tolman::report {
namespace {

using evaluation::PopulationHistory;

constexpr double kArrayPanel = 190;       // px, height of the panel of one array
constexpr std::size_t kMaxColumns = 100;  // cells of a heat map
constexpr std::size_t kMaxRows = 24;
constexpr std::array<const char*, 5> kLineColours = {kBlue, kOrange, kGreen, kVermilion, kPurple};

Range valuesOf(const PopulationHistory& array) {
  Range range{HUGE_VAL, -HUGE_VAL};
  for (const auto& values : array.activity) {
    for (const float value : values) {
      if (std::isfinite(value)) range.include(value);
    }
  }
  return range.length() >= 0 ? range : Range{0, 1};
}

std::string titleOf(const PopulationHistory& array) {
  const std::string unit = array.info.unit.empty() ? "" : ", " + array.info.unit;
  const std::string doc = array.info.doc.empty() ? "" : ": " + array.info.doc;
  return fmt::format("{} ({}{}){}", array.info.name, fmt::join(array.shape, " x "), unit, doc);
}

Eigen::AlignedBox2d panelBox(double top) {
  return frame(80, top + 35, 880, top + kArrayPanel - 45);
}

Range frameRange(const PopulationHistory& array) {
  return {static_cast<double>(array.frames.front()), static_cast<double>(array.frames.back())};
}

/// One line over time for each value.
void drawLines(Svg& svg, double top, const PopulationHistory& array) {
  Axes axes(svg, {titleOf(array), "frame", array.info.unit.empty() ? "value" : array.info.unit,
                  frameRange(array), valuesOf(array), panelBox(top)});
  const std::vector<double> frames(array.frames.begin(), array.frames.end());
  for (std::size_t i = 0; i < array.activity.front().size(); ++i) {
    std::vector<double> line;
    for (const auto& values : array.activity)
      line.push_back(std::isfinite(values[i]) ? values[i] : 0);
    axes.polyline(frames, line, kLineColours.at(i));
  }
}

/// Frames to the right, indices (row-major) upwards; both are thinned to the cells of the heat map.
void drawHeatMap(Svg& svg, double top, const PopulationHistory& array) {
  const std::size_t size = array.activity.front().size();
  const std::size_t columns = std::min(kMaxColumns, array.frames.size());
  const std::size_t rows = std::min(kMaxRows, size);
  const Range values = valuesOf(array);
  const Axes axes(svg, {titleOf(array),
                        "frame",
                        "index",
                        frameRange(array),
                        {0, static_cast<double>(size)},
                        panelBox(top)});
  Eigen::MatrixXd shown(columns, rows);
  for (std::size_t c = 0; c < columns; ++c) {
    const auto& row = array.activity[c * array.activity.size() / columns];
    for (std::size_t r = 0; r < rows; ++r) {
      const double value = row[r * size / rows];
      shown(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(r)) =
          std::isfinite(value) ? value - values.low : NAN;
    }
  }
  svg.image(axes.box().min(), axes.box().sizes(), pngUrl(ratePixels(shown, values.length())));
  colourBar(svg, {axes.box().center().x(), axes.box().min().y() - 8},
            fmt::format("{:.2g}", values.low), fmt::format("{:.2g}", values.high));
}

}  // namespace

std::string arrayFigure(const std::vector<evaluation::PopulationHistory>& arrays) {
  if (arrays.empty()) return "";
  const std::span shown = std::span(arrays).first(std::min(arrays.size(), kMaxPanels));
  Svg svg(900, kArrayPanel * static_cast<double>(shown.size()));
  double top = 0;
  for (const PopulationHistory& array : shown) {
    const bool few = array.activity.front().size() <= kLineColours.size();
    few ? drawLines(svg, top, array) : drawHeatMap(svg, top, array);
    top += kArrayPanel;
  }
  return svg.take();
}

}  // namespace tolman::report
