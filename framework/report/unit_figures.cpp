// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/raster.hpp"
#include "report/svg.hpp"

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

using evaluation::axisAngle;
using evaluation::PopulationHistory;
using evaluation::RateMap;

constexpr double kModulePanel = 900;  // px, of the maps of a module; two are side by side
constexpr double kMargin = 30;
constexpr double kColumn = kModulePanel + 2 * kMargin;
constexpr double kDial = 105;  // px, size of a tuning curve
constexpr double kTitle = 60;
constexpr double kBelow = 50;
constexpr int kGap = 1;  // px between rate maps
constexpr std::uint32_t kClear = 0;
constexpr std::uint32_t kUnvisited = 0xff1a0a24;  // a number below that of any rate's colour

void drawTitle(Svg& svg, const Eigen::Vector2d& middle, const std::string& title,
               const std::string& scores) {
  svg.text(middle, title, {TextAnchor::Middle, 15, 0, true});
  svg.text(middle + Eigen::Vector2d(0, 20), scores, {TextAnchor::Middle, 13});
}

std::string scoreText(const std::string& name, const std::optional<evaluation::UnitScore>& score) {
  if (!score) return fmt::format("{} not measurable here", name);
  return fmt::format("{} {:.2f} in the median, chance {:.2f}, {:.0f} % above", name, score->median,
                     score->chance, 100 * score->share_better);
}

/// Polar tuning curve: heading 0 is up, positive to the left.
void drawDial(Svg& svg, const Eigen::Vector2d& centre, const evaluation::TuningCurve& curve,
              double nominal) {
  constexpr double kRadius = 0.36 * kDial;
  const auto at = [&](double angle, double share) -> Eigen::Vector2d {
    return centre + share * kRadius * Eigen::Vector2d(-std::sin(angle), -std::cos(angle));
  };
  const double peak = std::max(*std::ranges::max_element(curve.rate), 1e-12);
  const double bin = 2 * std::numbers::pi / static_cast<double>(curve.rate.size());
  std::vector<Eigen::Vector2d> outline;
  for (std::size_t i = 0; i <= curve.rate.size(); ++i) {
    outline.push_back(
        at((static_cast<double>(i) + 0.5) * bin, curve.rate[i % curve.rate.size()] / peak));
  }
  svg.circle(centre, kRadius, "none", kFaintLine);
  svg.polyline(outline, kBlue, 1.5);
  svg.line(centre, at(curve.preferred, curve.mean_vector_length), kVermilion, 2);
  svg.text(centre + Eigen::Vector2d(0, kRadius + 12),
           fmt::format("{:.3g}°, peak {:.2g}", nominal * evaluation::kDegrees, peak),
           {TextAnchor::Middle, 10});
}

/// Draws the tuning curves of a ring. Returns the y of its lower end, px.
double drawRing(Svg& svg, double top, const PopulationHistory& ring,
                const evaluation::RingFigures& figures) {
  const auto& width = figures.scores.half_width_deg;
  drawTitle(svg, {svg.width() / 2, top + 25},
            fmt::format("{}: {} head direction units", ring.info.name, figures.units),
            scoreText("mean vector length", figures.scores.mean_vector_length) +
                (width ? fmt::format("; half width {:.0f}° in the median", width->median) : ""));
  const auto measured = measuredUnits(ring);
  Eigen::Vector2d centre(0, top + kTitle - kDial / 2);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    centre.x() += kDial;
    if (i == 0 || centre.x() > svg.width() - kDial / 2) centre = {67, centre.y() + kDial};
    drawDial(svg, centre, figures.scores.units[i].tuning,
             axisAngle(ring.info.axes[0], measured[i]));
  }
  return centre.y() + kDial / 2 + kBelow;
}

/// The rate maps of a module. Units of one row of the sheet are above each other; in each map
/// forward is up.
Pixels tiled(const std::vector<RateMap>& maps, Eigen::Index rows, double most) {
  const auto columns = static_cast<Eigen::Index>(maps.size()) / rows;
  const Eigen::Index right = maps[0].rate.rows() + kGap;
  const Eigen::Index up = maps[0].rate.cols() + kGap;
  Pixels pixels = Pixels::Constant(columns * up - kGap, rows * right - kGap, kClear);
  for (Eigen::Index i = 0; i < rows * columns; ++i) {
    pixels.block((columns - 1 - i % columns) * up, i / columns * right, up - kGap, right - kGap) =
        ratePixels(maps[static_cast<std::size_t>(i)].rate, most).cwiseMax(kUnvisited);
  }
  return pixels;
}

/// Draws the key of directions, lengths and colours. `tile`: width of a rate map, px.
void drawKey(Svg& svg, const Eigen::Vector2d& corner, const ArrayInfo& info, const RateMap& map,
             double tile, double peak, double metres_per_unit) {
  const double bin = map.bin * metres_per_unit;
  const double width = bin * static_cast<double>(map.rate.rows());
  const double metres = ticks({0, width}, 3).back();
  const double end = corner.x() + tile * metres / width;
  const double y = corner.y() + 18;
  svg.line({corner.x(), y}, {end, y}, kFrameLine, 3);
  svg.text({end + 8, y + 4},
           fmt::format("{:g} m; each map {:.0f} m by {:.0f} m, forward is up. Units: {} to the "
                       "right, {} up.",
                       metres, width, bin * static_cast<double>(map.rate.cols()), info.axes[0].name,
                       info.axes[1].name));
  colourBar(svg, {corner.x() + kModulePanel - 110, y}, "rate 0", fmt::format("peak {:.2g}", peak));
}

/// Draws the rate maps of a grid module. Returns the y of its lower end, px.
double drawSheet(Svg& svg, const Eigen::Vector2d& corner, const PopulationHistory& sheet,
                 const evaluation::SheetFigures& figures, const evaluation::StampedPoses& poses,
                 double metres_per_unit, bool metric) {
  const ArrayAxis& axis = sheet.info.axes[0];
  const double period = axis.period * (axis.unit == "m" ? metres_per_unit : 1);
  const evaluation::LatticeScore lattice = evaluation::bestLattice(figures.scores);
  drawTitle(svg, corner + Eigen::Vector2d(kModulePanel / 2, 25),
            fmt::format("{}: {} grid units, period {:.4g} {}", sheet.info.name, figures.units,
                        period, axis.unit),
            scoreText(fmt::format("{} score", lattice.name), lattice.score));
  const auto units = unitsAt(sheet, poses, measuredUnits(sheet), metric);
  std::vector<RateMap> maps;
  double peak = 1e-12;
  for (std::size_t i = 0; i < units.rates.size(); ++i) {
    maps.push_back(scoredMap(units, i, periodInMetres(sheet)));
    peak = std::max(peak, evaluation::highestRate(maps.back()));
  }
  const int rows = std::min(sheet.shape[0], evaluation::kMaxUnitsAlongAxis);
  const Pixels pixels = tiled(maps, rows, peak);
  const auto width = static_cast<double>(pixels.cols());
  const auto height = static_cast<double>(pixels.rows());
  const double zoom = kModulePanel / std::max(width, height);
  const Eigen::Vector2d place = corner + Eigen::Vector2d(0, kTitle);
  svg.image(place, zoom * Eigen::Vector2d(width, height), pngUrl(pixels));
  drawKey(svg, place + Eigen::Vector2d(0, zoom * height), sheet.info, maps[0],
          zoom * ((width + kGap) / rows - kGap), peak, metres_per_unit);
  return place.y() + zoom * height + kBelow;
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

std::string unitsFigure(const RunData& run) {
  const auto poses = evaluation::stampedPosesOf(run.places());
  if (!run.metrics.cells || poses.empty()) return "";
  const auto first = [](const auto& all) {
    return std::span(all).first(std::min(all.size(), kMaxPanels / 2));
  };
  const auto rings = first(run.cells.rings);
  const auto sheets = first(run.cells.sheets);
  const std::size_t across = std::clamp<std::size_t>(sheets.size(), 1, 2);
  Svg svg(kColumn * static_cast<double>(across), 0);
  double top = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    top = drawRing(svg, top, rings[i], run.metrics.cells->rings[i]);
  }
  double left = kMargin;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const double bottom = drawSheet(svg, {left, top}, sheets[i], run.metrics.cells->sheets[i],
                                    poses, run.metres, run.metrics.cells->truth);
    svg.extendTo(bottom);
    left += kColumn;
    if (left < svg.width()) continue;
    left = kMargin;
    top = svg.height();
  }
  svg.extendTo(top);
  return svg.take();
}

}  // namespace tolman::report
