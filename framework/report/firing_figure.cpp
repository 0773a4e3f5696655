// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "report/axes.hpp"
#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/raster.hpp"

namespace tolman::report {
namespace {

constexpr double kUnitPanel = 430;  // px
constexpr double kField = 14;       // px, circle around a field
constexpr double kBelowAxes = 52;   // px

void drawUnit(Svg& svg, double left, const DrawnUnit& unit) {
  const evaluation::RateMap& map = unit.rates;
  const Range x{map.corner.x(), map.corner.x() + map.bin * static_cast<double>(map.rate.rows())};
  const Range y{map.corner.y(), map.corner.y() + map.bin * static_cast<double>(map.rate.cols())};
  const Axes axes(svg, {unit.name, "right (m)", "forward (m)", x, y,
                        frame(left + 70, 50, left + kUnitPanel - 15, kUnitPanel - 60), true});
  const Eigen::AlignedBox2d& box = axes.box();
  const double peak = evaluation::highestRate(map);
  svg.image(box.min(), box.sizes(), pngUrl(ratePixels(map.rate, peak)));
  colourBar(svg, {box.center().x(), box.min().y() - 12}, "rate 0",
            fmt::format("peak {:.2g}", peak));
  for (const Eigen::Vector2d& field : unit.fields) {
    svg.circle(axes.at(field.x(), field.y()), kField, "none", kVermilion);
  }
  svg.text({box.center().x(), box.max().y() + kBelowAxes}, unit.measures, {TextAnchor::Middle, 11});
}

}  // namespace

std::string firingFigure(const std::vector<DrawnUnit>& units) {
  if (units.empty()) return "";
  Svg svg(kUnitPanel * static_cast<double>(units.size()), kUnitPanel);
  for (std::size_t i = 0; i < units.size(); ++i) {
    drawUnit(svg, kUnitPanel * static_cast<double>(i), units[i]);
  }
  return svg.take();
}

}  // namespace tolman::report
