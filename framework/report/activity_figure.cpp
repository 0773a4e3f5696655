// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "report/axes.hpp"
#include "report/colour_map.hpp"
#include "report/figures.hpp"

namespace tolman::report {
namespace {

constexpr std::size_t kMoments = 4;
constexpr double kPanel = 225;  // px
constexpr double kRing = 170;
constexpr double kTop = 60;

float highest(const std::vector<float>& values) {
  float most = 1e-9F;
  for (const float value : values) most = std::isfinite(value) ? std::max(most, value) : most;
  return most;
}

double shareOf(float value, float most) {
  return std::isfinite(value) ? static_cast<double>(value) / most : 0;
}

/// Units as sectors in the direction of their heading: 0 is up, positive to the left. The length of
/// a sector is the activity.
void drawRing(Svg& svg, const Eigen::Vector2d& centre, const ArrayAxis& axis,
              const std::vector<float>& activity, double heading) {
  const double outer = kRing / 2;
  const double inner = 0.35 * outer;
  const auto at = [&](double angle, double radius) -> Eigen::Vector2d {
    return centre + radius * Eigen::Vector2d(-std::sin(angle), -std::cos(angle));
  };
  svg.circle(centre, inner, "none", "#bbbbbb");
  const float most = highest(activity);
  for (std::size_t i = 0; i < activity.size(); ++i) {
    const double angle = axisAngle(axis, i);
    const double share = shareOf(activity[i], most);
    svg.line(at(angle, inner), at(angle, inner + share * (outer - inner)), rateColour(share), 6);
  }
  svg.line(centre, at(heading, inner), kVermilion, 2.5);
}

void drawSheet(Svg& svg, const Eigen::Vector2d& corner, const PopulationHistory& sheet,
               const std::vector<float>& activity) {
  const int rows = sheet.shape[0];
  const int columns = sheet.shape[1];
  const double cell = kRing / std::max(rows, columns);
  const float most = highest(activity);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const std::size_t i = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
                            static_cast<std::size_t>(c);
      // Slightly larger than a cell, against visible seams.
      svg.rectangle(corner + cell * Eigen::Vector2d(r, columns - 1 - c), {cell + 0.4, cell + 0.4},
                    rateColour(shareOf(activity[i], most)));
    }
  }
}

std::string captionOf(const CellHistory& cells) {
  std::string text;
  if (!cells.ring.empty()) {
    text = fmt::format("{}: {} 0 is up, positive to the left", cells.ring.info.name,
                       cells.ring.info.axes[0].name);
  }
  if (!cells.sheet.empty()) {
    const auto& axes = cells.sheet.info.axes;
    text += fmt::format("{}{}: {} to the right, {} up", text.empty() ? "" : "; ",
                        cells.sheet.info.name, axes[0].name, axes[1].name);
  }
  return text;
}

std::vector<std::size_t> moments(std::size_t count) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < kMoments && count > 0; ++i) {
    chosen.push_back(i * (count - 1) / (kMoments - 1));
  }
  return chosen;
}

}  // namespace

std::string activityFigure(const CellHistory& cells, const std::vector<Decision>& decisions) {
  if (cells.ring.empty() && cells.sheet.empty()) return "";
  std::map<std::int64_t, double> headings;
  for (const Decision& decision : decisions) headings[decision.frame] = decision.heading;
  Svg svg(kMoments * kPanel, 485);
  svg.text({kMoments * kPanel / 2, 26}, "Activity of head direction cells and grid cells",
           {TextAnchor::Middle, 13, 0, true});
  const auto& frames = cells.ring.empty() ? cells.sheet.frames : cells.ring.frames;
  double x = 0;
  for (const std::size_t i : moments(frames.size())) {
    const double heading = headings[frames[i]];
    svg.text(
        {x + kPanel / 2, kTop - 12},
        fmt::format("frame {}, heading {:.1f} deg", frames[i], heading * 180 / std::numbers::pi),
        {TextAnchor::Middle, 11});
    if (i < cells.ring.frames.size()) {
      drawRing(svg, {x + kPanel / 2, kTop + kRing / 2}, cells.ring.info.axes[0],
               cells.ring.activity[i], heading);
    }
    if (i < cells.sheet.frames.size()) {
      drawSheet(svg, {x + (kPanel - kRing) / 2, kTop + kRing + 30}, cells.sheet,
                cells.sheet.activity[i]);
    }
    x += kPanel;
  }
  svg.text({kMoments * kPanel / 2, 448}, captionOf(cells), {TextAnchor::Middle, 11});
  colourBar(svg, {kMoments * kPanel / 2, 468}, "activity 0", "maximum of each picture");
  return svg.take();
}

}  // namespace tolman::report
