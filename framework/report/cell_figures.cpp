// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the cells: the firing of single units, and of all of a population; and the measures
// of all units.
#include <fmt/format.h>

#include <numbers>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/svg.hpp"

namespace tolman::report {
namespace {

using Json = nlohmann::ordered_json;
using evaluation::axisAngle;
using evaluation::axisValue;
using evaluation::kDegrees;
using evaluation::PopulationHistory;
using evaluation::RateMap;

/// Heading 0 is up, positive to the left.
Eigen::Vector2d polar(const Eigen::Vector2d& centre, double angle, double radius) {
  return centre + radius * Eigen::Vector2d(-std::sin(angle), -std::cos(angle));
}

constexpr double kUnitPanel = 430;    // px
constexpr double kModulePanel = 900;  // px, of the maps of a module; two are side by side
constexpr double kMargin = 30;
constexpr double kColumn = kModulePanel + 2 * kMargin;
constexpr double kDial = 105;  // px, size of a tuning curve
constexpr double kTitle = 60;
constexpr double kBelow = 50;
constexpr int kGap = 1;                           // px between rate maps
constexpr std::uint32_t kUnvisited = 0xff1a0a24;  // a number below that of any rate's colour

void drawUnit(Svg& svg, double left, const DrawnUnit& unit) {
  constexpr double kField = 14, kBelowAxes = 52;  // px
  const RateMap& map = unit.rates;
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

/// Name of a population and the score of its units.
void drawTitle(Svg& svg, const Eigen::Vector2d& middle, const std::string& title,
               const std::string& name, const std::optional<evaluation::UnitScore>& score,
               const std::string& more = "") {
  svg.text(middle, title, {TextAnchor::Middle, 15, 0, true});
  const std::string text =
      score ? fmt::format("{} {:.2f} in the median, chance {:.2f}, {:.0f} % above", name,
                          score->median, score->chance, 100 * score->share_better)
            : name + " not measurable here";
  svg.text(middle + Eigen::Vector2d(0, 20), text + more, {TextAnchor::Middle, 13});
}

/// A tuning curve, relative to its peak, with the mean vector.
void drawDial(Svg& svg, const Eigen::Vector2d& centre, const evaluation::TuningCurve& curve,
              double nominal) {
  constexpr double kRadius = 0.36 * kDial;
  const std::size_t bins = curve.rate.size();
  const double peak = std::max(*std::ranges::max_element(curve.rate), 1e-12);
  std::vector<Eigen::Vector2d> outline;
  for (std::size_t i = 0; i <= bins; ++i) {
    const double angle =
        (static_cast<double>(i) + 0.5) * 2 * std::numbers::pi / static_cast<double>(bins);
    outline.push_back(polar(centre, angle, curve.rate[i % bins] / peak * kRadius));
  }
  svg.circle(centre, kRadius, "none", kFaintLine);
  svg.polyline(outline, kBlue, 1.5);
  svg.line(centre, polar(centre, curve.preferred, curve.mean_vector_length * kRadius), kVermilion,
           2);
  svg.text(centre + Eigen::Vector2d(0, kRadius + 12),
           fmt::format("{:.3g}°, peak {:.2g}", nominal * kDegrees, peak), {TextAnchor::Middle, 10});
}

/// Draws the tuning curves of a ring. Returns the y of its lower end, px.
double drawRing(Svg& svg, double top, const PopulationHistory& ring,
                const evaluation::PopulationFigures& figures) {
  const auto& width = figures.scores.of("half_width_deg");
  drawTitle(svg, {svg.width() / 2, top + 25},
            fmt::format("{}: {} head direction units", ring.info.name, figures.units),
            "mean vector length", figures.scores.of("mean_vector_length"),
            width ? fmt::format("; half width {:.0f}° in the median", width->median) : "");
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

/// The rate maps of a module: units of one row above each other, forward up in each.
Pixels tiled(const std::vector<RateMap>& maps, Eigen::Index rows, double most) {
  const auto columns = static_cast<Eigen::Index>(maps.size()) / rows;
  const Eigen::Index right = maps[0].rate.rows() + kGap;
  const Eigen::Index up = maps[0].rate.cols() + kGap;
  Pixels pixels = Pixels::Zero(columns * up - kGap, rows * right - kGap);
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
                 const evaluation::PopulationFigures& figures,
                 const evaluation::StampedPoses& poses, const RunData& run) {
  const double period = figures.period * (figures.unit == "m" ? run.metres : 1);
  const evaluation::Lattice lattice = evaluation::bestLattice(figures.scores);
  drawTitle(svg, corner + Eigen::Vector2d(kModulePanel / 2, 25),
            fmt::format("{}: {} grid units, period {:.4g} {}", sheet.info.name, figures.units,
                        period, figures.unit),
            fmt::format("{} score", lattice.name), figures.scores.scores[lattice.score]);
  const auto units = unitsAt(sheet, poses, measuredUnits(sheet), run.metrics.cells->truth);
  std::vector<RateMap> maps;
  double peak = 1e-12;
  for (std::size_t i = 0; i < units.rates.size(); ++i) {
    maps.push_back(scoredMap(units, i, periodInMetres(sheet)));
    peak = std::max(peak, evaluation::highestRate(maps.back()));
  }
  const int rows = std::min(sheet.shape[0], evaluation::kMaxUnitsAlongAxis);
  const Pixels pixels = tiled(maps, rows, peak);
  const Eigen::Vector2d size(static_cast<double>(pixels.cols()),
                             static_cast<double>(pixels.rows()));
  const double zoom = kModulePanel / size.maxCoeff();
  const Eigen::Vector2d place = corner + Eigen::Vector2d(0, kTitle);
  svg.image(place, zoom * size, pngUrl(pixels));
  drawKey(svg, place + Eigen::Vector2d(0, zoom * size.y()), sheet.info, maps[0],
          zoom * ((size.x() + kGap) / rows - kGap), peak, run.metres);
  return place.y() + zoom * size.y() + kBelow;
}

evaluation::RateMap inMetres(evaluation::RateMap map, const RunData& run) {
  map.corner *= run.metres;
  map.bin *= run.metres;
  return map;
}

/// Of the k-th unit that is measured.
DrawnUnit headDirectionUnit(const RunData& run, std::size_t k,
                            const evaluation::StampedPoses& poses) {
  const PopulationHistory& ring = run.cells.rings[0];
  const std::size_t unit = measuredUnits(ring)[k];
  const evaluation::TuningCurve& curve = run.metrics.cells->rings[0].scores.units[k].tuning;
  const std::string width =
      curve.half_width ? fmt::format(", half width {:.0f} deg", *curve.half_width * kDegrees) : "";
  return {fmt::format("head direction unit {} of {}, {:.3g} deg", unit + 1, ring.shape[0],
                      axisAngle(ring.info.axes[0], unit) * kDegrees),
          fmt::format("mean vector length {:.2f} towards {:.0f} deg{}", curve.mean_vector_length,
                      curve.preferred * kDegrees, width),
          inMetres(firingMap(unitsAt(ring, poses, {unit}, run.metrics.cells->truth), 0), run),
          {}};
}

DrawnUnit gridUnit(const RunData& run, const evaluation::StampedPoses& poses) {
  const PopulationHistory& sheet = run.cells.sheets[0];
  const std::size_t unit = measuredUnits(sheet)[0];
  const auto columns = static_cast<std::size_t>(sheet.shape[1]);
  const std::size_t row = unit / columns, column = unit % columns;
  const auto& axes = sheet.info.axes;
  const evaluation::PopulationScores& all = run.metrics.cells->sheets[0].scores;
  const evaluation::MeasuredUnit& measured = all.units[0];
  const evaluation::Lattice lattice = evaluation::bestLattice(all);
  const auto& value = measured.scores[lattice.score];
  const auto& chance = all.scores[lattice.score];
  const std::string score = value && chance ? fmt::format(", {} score {:.2f} (chance {:.2f})",
                                                          lattice.name, *value, chance->chance)
                                            : ", too narrow an area for grid scores";
  DrawnUnit drawn{
      fmt::format("grid unit ({}, {}), phase ({:.3g}, {:.3g}) {}", row + 1, column + 1,
                  axisValue(axes[0], row), axisValue(axes[1], column), axes[0].unit),
      fmt::format("{} field{}, {:.2f} bits{}", measured.fields, measured.fields == 1 ? "" : "s",
                  *measured.scores[all.indexOf("spatial_information_bits")], score),
      inMetres(firingMap(unitsAt(sheet, poses, {unit}, run.metrics.cells->truth), 0), run),
      {}};
  drawn.fields = evaluation::fields(drawn.rates);
  return drawn;
}

/// What describes a unit of a ring, or of a sheet.
Json memberJson(const PopulationHistory& population, std::size_t i,
                const evaluation::MeasuredUnit& unit) {
  const auto& axes = population.info.axes;
  if (axes.size() == 1) {
    return {{"unit", i + 1},
            {"nominal_deg", axisAngle(axes[0], i) * kDegrees},
            {"preferred_deg", unit.tuning.preferred * kDegrees},
            {"tuning", unit.tuning.rate}};
  }
  const auto columns = static_cast<std::size_t>(population.shape[1]);
  const std::size_t row = i / columns, column = i % columns;
  return {{"unit", {row + 1, column + 1}},
          {"nominal", {axisValue(axes[0], row), axisValue(axes[1], column)}},
          {"fields", unit.fields}};
}

/// All measured units of all populations.
Json unitsJson(const std::vector<PopulationHistory>& populations,
               const std::vector<evaluation::PopulationFigures>& figures) {
  Json list = Json::array();
  for (std::size_t p = 0; p < populations.size(); ++p) {
    const evaluation::PopulationScores& scores = figures[p].scores;
    const std::vector<std::size_t> measured = measuredUnits(populations[p]);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      Json& json = list.emplace_back(Json{{"array", figures[p].array}});
      json.update(memberJson(populations[p], measured[i], scores.units[i]));
      for (std::size_t k = 0; k < scores.kinds.size(); ++k) {
        const auto& value = scores.units[i].scores[k];
        json[std::string(scores.kinds[k].key)] = value ? Json(*value) : Json();
      }
    }
  }
  return list;
}

}  // namespace

std::string firingFigure(const std::vector<DrawnUnit>& units) {
  if (units.empty()) return "";
  Svg svg(kUnitPanel * static_cast<double>(units.size()), kUnitPanel);
  double left = 0;
  for (const DrawnUnit& unit : units) {
    drawUnit(svg, left, unit);
    left += kUnitPanel;
  }
  return svg.take();
}

std::string unitsFigure(const RunData& run) {
  const auto poses = evaluation::stampedPosesOf(run.places());
  if (!run.metrics.cells || poses.empty()) return "";
  const auto& [rings, sheets] = run.cells;
  const std::size_t across = std::clamp<std::size_t>(sheets.size(), 1, 2);
  Svg svg(kColumn * static_cast<double>(across), 0);
  double top = 0;
  for (std::size_t i = 0; i < std::min(rings.size(), kMaxPanels / 2); ++i) {
    top = drawRing(svg, top, rings[i], run.metrics.cells->rings[i]);
  }
  double left = kMargin;
  for (std::size_t i = 0; i < std::min(sheets.size(), kMaxPanels / 2); ++i) {
    svg.extendTo(drawSheet(svg, {left, top}, sheets[i], run.metrics.cells->sheets[i], poses, run));
    left += kColumn;
    if (left < svg.width()) continue;
    left = kMargin;
    top = svg.height();
  }
  svg.extendTo(top);
  return svg.take();
}

std::vector<DrawnUnit> drawnUnits(const RunData& run) {
  std::vector<DrawnUnit> units;
  const auto poses = evaluation::stampedPosesOf(run.places());
  if (poses.empty() || !run.metrics.cells) return units;
  if (!run.cells.rings.empty()) {
    const std::size_t opposite = measuredUnits(run.cells.rings[0]).size() / 2;
    units = {headDirectionUnit(run, 0, poses), headDirectionUnit(run, opposite, poses)};
  }
  if (!run.cells.sheets.empty()) units.push_back(gridUnit(run, poses));
  return units;
}

Json neuronsJson(const RunData& run) {
  if (!run.metrics.cells) return nullptr;
  const evaluation::CellFigures& figures = *run.metrics.cells;
  return {{"places", figures.truth ? "truth" : "map"},
          {"head_direction", unitsJson(run.cells.rings, figures.rings)},
          {"grid", unitsJson(run.cells.sheets, figures.sheets)}};
}

}  // namespace tolman::report
