// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/raster.hpp"
#include "report/svg.hpp"

namespace tolman::report {
namespace {

using evaluation::PopulationHistory;

constexpr std::size_t kMoments = 4;
constexpr double kMomentPanel = 225;  // px
constexpr double kRing = 170;
constexpr double kRow = kRing + 40;
constexpr double kRowsTop = 60;

float highest(const std::vector<float>& values) {
  float most = 1e-9F;
  for (const float value : values) most = std::isfinite(value) ? std::max(most, value) : most;
  return most;
}

/// Draws units as sectors in the direction of their heading (0 is up, positive to the left). The
/// length of a sector is the activity.
void drawRing(Svg& svg, const Eigen::Vector2d& centre, const ArrayAxis& axis,
              const std::vector<float>& activity, double heading) {
  const double outer = kRing / 2;
  const double inner = 0.35 * outer;
  const auto at = [&](double angle, double radius) -> Eigen::Vector2d {
    return centre + radius * Eigen::Vector2d(-std::sin(angle), -std::cos(angle));
  };
  svg.circle(centre, inner, "none", kFaintLine);
  const float most = highest(activity);
  for (std::size_t i = 0; i < activity.size(); ++i) {
    const double angle = evaluation::axisAngle(axis, i);
    const double share = std::isfinite(activity[i]) ? activity[i] / most : 0;
    svg.line(at(angle, inner), at(angle, inner + share * (outer - inner)), rateColour(share), 6);
  }
  svg.line(centre, at(heading, inner), kVermilion, 2.5);
}

void drawSheet(Svg& svg, const Eigen::Vector2d& corner, const PopulationHistory& sheet,
               const std::vector<float>& activity) {
  const Eigen::Map<const Eigen::Matrix<float, -1, -1, Eigen::RowMajor>> rates(
      activity.data(), sheet.shape[0], sheet.shape[1]);
  svg.image(corner,
            kRing / std::max(sheet.shape[0], sheet.shape[1]) *
                Eigen::Vector2d(sheet.shape[0], sheet.shape[1]),
            pngUrl(ratePixels(rates.cast<double>(), static_cast<double>(highest(activity)))));
}

/// Draws a population at a frame; nothing if it was not recorded there.
void drawAt(Svg& svg, const Eigen::Vector2d& centre, const PopulationHistory& population,
            std::int64_t frame, double heading) {
  const auto at = std::ranges::lower_bound(population.frames, frame);
  if (at == population.frames.end() || *at != frame) return;
  const auto& activity =
      population.activity[static_cast<std::size_t>(at - population.frames.begin())];
  if (population.shape.size() == 1) {
    drawRing(svg, centre, population.info.axes[0], activity, heading);
  } else {
    drawSheet(svg, centre - Eigen::Vector2d::Constant(kRing / 2), population, activity);
  }
}

std::string captionOf(const ArrayInfo& info) {
  if (info.axes.size() == 1) {
    return fmt::format("{}: {} 0 is up, positive to the left", info.name, info.axes[0].name);
  }
  const ArrayAxis& right = info.axes[0];
  return fmt::format("{}, one period of {:.4g} {}: {} to the right, {} up", info.name, right.period,
                     right.unit, right.name, info.axes[1].name);
}

std::vector<std::size_t> moments(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < kMoments && count > 0; ++i) {
    chosen.push_back(i * (count - 1) / (kMoments - 1));
  }
  return chosen;
}

constexpr double kArrayPanel = 190;       // px, height of the panel of one array
constexpr std::size_t kMaxColumns = 100;  // cells of a heat map
constexpr std::size_t kMaxRows = 24;

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
  const std::vector<double> frames(array.frames.begin(), array.frames.end());
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < array.activity.front().size(); ++i) {
    Curve& curve = curves.emplace_back(Curve{"", lineColour(i), frames, {}});
    for (const auto& values : array.activity) {
      curve.y.push_back(std::isfinite(values[i]) ? values[i] : 0);
    }
  }
  plot(svg,
       {titleOf(array), "frame", array.info.unit.empty() ? "value" : array.info.unit,
        frameRange(array), valuesOf(array), panelBox(top)},
       curves);
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

std::string activityFigure(const evaluation::CellHistory& cells,
                           const std::vector<Decision>& decisions) {
  std::vector<const PopulationHistory*> rows;
  for (const PopulationHistory& ring : cells.rings) rows.push_back(&ring);
  for (const PopulationHistory& sheet : cells.sheets) rows.push_back(&sheet);
  if (rows.empty()) return "";
  std::map<std::int64_t, double> headings;
  for (const Decision& decision : decisions) headings[decision.frame] = decision.heading;
  const double bottom = kRowsTop + kRow * static_cast<double>(rows.size());
  Svg svg(kMoments * kMomentPanel, bottom + 25);
  svg.text({kMoments * kMomentPanel / 2, 26}, "Activity of head direction cells and grid cells",
           {TextAnchor::Middle, 13, 0, true});
  double x = 0;
  for (const std::size_t i : moments(rows[0]->frames.size())) {
    const std::int64_t frame = rows[0]->frames[i];
    svg.text(
        {x + kMomentPanel / 2, kRowsTop - 12},
        fmt::format("frame {}, heading {:.1f} deg", frame, headings[frame] * evaluation::kDegrees),
        {TextAnchor::Middle, 11});
    double y = kRowsTop;
    for (const PopulationHistory* row : rows) {
      drawAt(svg, {x + kMomentPanel / 2, y + kRing / 2}, *row, frame, headings[frame]);
      y += kRow;
    }
    x += kMomentPanel;
  }
  double y = kRowsTop + kRing + 20;
  for (const PopulationHistory* row : rows) {
    svg.text({kMoments * kMomentPanel / 2, y}, captionOf(row->info), {TextAnchor::Middle, 11});
    y += kRow;
  }
  colourBar(svg, {kMoments * kMomentPanel / 2, bottom + 8}, "activity 0",
            "maximum of each picture");
  return svg.take();
}

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
