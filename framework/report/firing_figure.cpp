// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/axes.hpp"
#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/neurons.hpp"

namespace tolman::report {
namespace {

constexpr double kPanel = 430;  // px

Eigen::AlignedBox2d panel(const Eigen::Vector2d& corner) {
  return {corner + Eigen::Vector2d(70, 50), corner + Eigen::Vector2d(kPanel - 15, kPanel - 60)};
}

Axes drawRates(Svg& svg, const Eigen::Vector2d& corner, const std::string& title,
               const RateMap& map) {
  const Range x{map.corner.x(), map.corner.x() + map.bin * static_cast<double>(map.rate.rows())};
  const Range y{map.corner.y(), map.corner.y() + map.bin * static_cast<double>(map.rate.cols())};
  const Axes axes(svg, {title, "right (m)", "forward (m)", x, y, panel(corner), true});
  const double most = highestRate(map);
  const double side = axes.pixelsX(map.bin);
  for (Eigen::Index i = 0; i < map.rate.rows(); ++i) {
    for (Eigen::Index j = 0; j < map.rate.cols(); ++j) {
      if (std::isnan(map.rate(i, j))) continue;
      const Eigen::Vector2d at = axes.at(map.corner.x() + map.bin * static_cast<double>(i),
                                         map.corner.y() + map.bin * static_cast<double>(j + 1));
      svg.rectangle(at, {side + 0.3, side + 0.3},
                    rateColour(map.rate(i, j) / std::max(most, 1e-12)));
    }
  }
  const Eigen::AlignedBox2d& box = axes.box();
  colourBar(svg, {box.center().x(), box.min().y() - 12}, "activity 0", fmt::format("{:.2g}", most));
  return axes;
}

std::string periodicityText(const Neurons& neurons, const GridUnit& unit) {
  if (!unit.periodicity || !neurons.chance)
    return "the path is too narrow to measure a square lattice";
  const Periodicity& lattice = *unit.periodicity;
  return fmt::format("square lattice {:.2f}, by chance {:.2f}: {:.0f} m at {:.0f} deg",
                     lattice.score, *neurons.chance, lattice.spacing, lattice.direction * kDegrees);
}

/// Rate map with a circle around each field.
void drawGridUnit(Svg& svg, const Neurons& neurons, const DrawnUnit& drawn) {
  constexpr double kRing = 14;       // px
  constexpr double kBelowAxes = 52;  // px
  const GridUnit& unit = neurons.sheet[drawn.unit];
  const Axes axes =
      drawRates(svg, {0, kPanel},
                fmt::format("{}, phase {}: {} field{}, {:.2f} bits", drawn.name, drawn.phase,
                            unit.fields, unit.fields == 1 ? "" : "s", unit.bits),
                drawn.rates);
  for (const Eigen::Vector2d& centre : fields(drawn.rates)) {
    svg.circle(axes.at(centre.x(), centre.y()), kRing, "none", kVermilion);
  }
  svg.text({axes.box().center().x(), axes.box().max().y() + kBelowAxes},
           periodicityText(neurons, unit), {TextAnchor::Middle, 11});
}

void drawTuning(Svg& svg, const Eigen::Vector2d& corner, const std::string& title,
                const TuningCurve& curve) {
  std::vector<double> degrees;
  double most = 0;
  for (std::size_t i = 0; i < curve.rate.size(); ++i) {
    degrees.push_back((static_cast<double>(i) + 0.5) * 360 /
                      static_cast<double>(curve.rate.size()));
    most = std::max(most, curve.rate[i]);
  }
  Axes axes(svg, {title,
                  "heading of the map (deg)",
                  "mean activity",
                  {0, 360},
                  {0, std::max(1.05 * most, 1e-9)},
                  panel(corner)});
  axes.polyline(degrees, curve.rate, kBlue, 2);
  axes.legend({{kBlue, fmt::format("mean vector length {:.2f} towards {:.0f} deg",
                                   curve.mean_vector_length, curve.preferred * kDegrees)}});
}

}  // namespace

std::string firingFigure(const Neurons& neurons, const std::vector<DrawnUnit>& units) {
  if (units.empty()) return "";
  Svg svg(2 * kPanel, 2 * kPanel);
  double left = 0;
  for (const DrawnUnit& drawn : units) {
    if (drawn.population == Population::Sheet) {
      drawGridUnit(svg, neurons, drawn);
    } else {
      drawRates(svg, {left, 0}, drawn.name, drawn.rates);
      left += kPanel;
    }
  }
  if (units.front().population == Population::Ring) {
    drawTuning(svg, {kPanel, kPanel},
               "tuning of head direction unit " + std::to_string(units.front().unit + 1),
               neurons.ring[units.front().unit].tuning);
  }
  return svg.take();
}

}  // namespace tolman::report
