// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the cells: their activity, other arrays over time, and the firing of single units.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <numbers>
#include <span>

#include "report/axes.hpp"
#include "report/figures.hpp"
#include "report/svg.hpp"

namespace tolman::report {
namespace {

using evaluation::axisAngle;
using evaluation::PopulationHistory;
using evaluation::RateMap;

/// Heading 0 is up, positive to the left.
Eigen::Vector2d polar(const Eigen::Vector2d& centre, double angle, double radius) {
  return centre + radius * Eigen::Vector2d(-std::sin(angle), -std::cos(angle));
}

float highest(const std::vector<float>& values) {
  float most = 1e-9F;
  for (const float value : values) most = std::isfinite(value) ? std::max(most, value) : most;
  return most;
}

// Activity at some moments.

constexpr std::size_t kMoments = 4;
constexpr double kMomentPanel = 225;  // px
constexpr double kRing = 170;
constexpr double kRow = kRing + 40;
constexpr double kRowsTop = 60;

/// Units of a ring are sectors in their heading, as long as their activity; a sheet is a picture.
void drawActivity(Svg& svg, const Eigen::Vector2d& centre, const PopulationHistory& population,
                  const std::vector<float>& activity, double heading) {
  const float most = highest(activity);
  if (population.shape.size() == 2) {
    const Eigen::Map<const Eigen::Matrix<float, -1, -1, Eigen::RowMajor>> rates(
        activity.data(), population.shape[0], population.shape[1]);
    const Eigen::Vector2d size(population.shape[0], population.shape[1]);
    svg.image(centre - Eigen::Vector2d::Constant(kRing / 2), kRing / size.maxCoeff() * size,
              pngUrl(ratePixels(rates.cast<double>(), static_cast<double>(most))));
    return;
  }
  constexpr double kOuter = kRing / 2, kInner = 0.35 * kOuter;
  svg.circle(centre, kInner, "none", kFaintLine);
  for (std::size_t i = 0; i < activity.size(); ++i) {
    const double angle = axisAngle(population.info.axes[0], i);
    const double share = std::isfinite(activity[i]) ? activity[i] / most : 0;
    svg.line(polar(centre, angle, kInner), polar(centre, angle, kInner + share * (kOuter - kInner)),
             rateColour(share), 6);
  }
  svg.line(centre, polar(centre, heading, kInner), kVermilion, 2.5);
}

std::string captionOf(const ArrayInfo& info) {
  const ArrayAxis& first = info.axes[0];
  if (info.axes.size() == 1) {
    return fmt::format("{}: {} 0 is up, positive to the left", info.name, first.name);
  }
  return fmt::format("{}, one period of {:.4g} {}: {} to the right, {} up", info.name, first.period,
                     first.unit, first.name, info.axes[1].name);
}

// Arrays over time.

constexpr double kArrayPanel = 190;  // px, height of the panel of one array

/// Lines over time for few values, else a heat map over frames and indices, both thinned.
void drawArray(Svg& svg, double top, const PopulationHistory& array) {
  constexpr std::size_t kMaxColumns = 100, kMaxRows = 24;  // cells of a heat map
  const std::vector<double> frames(array.frames.begin(), array.frames.end());
  const std::size_t size = array.activity.front().size();
  const ArrayInfo& info = array.info;
  Range values = Range::none();
  for (const auto& row : array.activity) {
    for (const float value : row) {
      if (std::isfinite(value)) values.include(value);
    }
  }
  if (values.length() < 0) values = {0, 1};
  AxesPlan plan{
      fmt::format("{} ({}{}{}){}{}", info.name, fmt::join(array.shape, " x "),
                  info.unit.empty() ? "" : ", ", info.unit, info.doc.empty() ? "" : ": ", info.doc),
      "frame",
      info.unit.empty() ? "value" : info.unit,
      {frames.front(), frames.back()},
      values,
      frame(80, top + 35, 880, top + kArrayPanel - 45)};
  if (size <= kLineColours.size()) {
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < size; ++i) {
      Curve& curve = curves.emplace_back(Curve{"", lineColour(i), frames, {}});
      for (const auto& row : array.activity) {
        curve.y.push_back(std::isfinite(row[i]) ? row[i] : 0);
      }
    }
    plot(svg, plan, curves);
    return;
  }
  plan.y_label = "index";
  plan.y = {0, static_cast<double>(size)};
  const Axes axes(svg, plan);
  Eigen::MatrixXd shown(std::min(kMaxColumns, frames.size()), std::min(kMaxRows, size));
  for (Eigen::Index c = 0; c < shown.rows(); ++c) {
    const auto& row = array.activity[static_cast<std::size_t>(c) * frames.size() /
                                     static_cast<std::size_t>(shown.rows())];
    for (Eigen::Index r = 0; r < shown.cols(); ++r) {
      const double value =
          row[static_cast<std::size_t>(r) * size / static_cast<std::size_t>(shown.cols())];
      shown(c, r) = std::isfinite(value) ? value - values.low : NAN;
    }
  }
  svg.image(axes.box().min(), axes.box().sizes(), pngUrl(ratePixels(shown, values.length())));
  colourBar(svg, {axes.box().center().x(), axes.box().min().y() - 8},
            fmt::format("{:.2g}", values.low), fmt::format("{:.2g}", values.high));
}

// Firing of units.

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
           fmt::format("{:.3g}°, peak {:.2g}", nominal * evaluation::kDegrees, peak),
           {TextAnchor::Middle, 10});
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

}  // namespace

std::string activityFigure(const evaluation::CellHistory& cells,
                           const std::vector<Decision>& decisions) {
  constexpr double kWidth = kMoments * kMomentPanel;
  std::vector<const PopulationHistory*> rows;
  for (const auto* list : {&cells.rings, &cells.sheets}) {
    for (const PopulationHistory& population : *list) rows.push_back(&population);
  }
  if (rows.empty()) return "";
  std::map<std::int64_t, double> headings;
  for (const Decision& decision : decisions) headings[decision.frame] = decision.heading;
  const double bottom = kRowsTop + kRow * static_cast<double>(rows.size());
  Svg svg(kWidth, bottom + 25);
  svg.text({kWidth / 2, 26}, "Activity of head direction cells and grid cells",
           {TextAnchor::Middle, 13, 0, true});
  const std::vector<std::int64_t>& frames = rows[0]->frames;
  for (std::size_t i = 0; i < kMoments; ++i) {
    const double x = (static_cast<double>(i) + 0.5) * kMomentPanel;
    const std::int64_t frame = frames[i * (frames.size() - 1) / (kMoments - 1)];
    svg.text(
        {x, kRowsTop - 12},
        fmt::format("frame {}, heading {:.1f} deg", frame, headings[frame] * evaluation::kDegrees),
        {TextAnchor::Middle, 11});
    double y = kRowsTop + kRing / 2;
    for (const PopulationHistory* row : rows) {
      const auto at = std::ranges::lower_bound(row->frames, frame);
      if (at != row->frames.end() && *at == frame) {  // else it was not recorded there
        drawActivity(svg, {x, y}, *row,
                     row->activity[static_cast<std::size_t>(at - row->frames.begin())],
                     headings[frame]);
      }
      y += kRow;
    }
  }
  double y = kRowsTop + kRing + 20;
  for (const PopulationHistory* row : rows) {
    svg.text({kWidth / 2, y}, captionOf(row->info), {TextAnchor::Middle, 11});
    y += kRow;
  }
  colourBar(svg, {kWidth / 2, bottom + 8}, "activity 0", "maximum of each picture");
  return svg.take();
}

std::string arrayFigure(const std::vector<PopulationHistory>& arrays) {
  if (arrays.empty()) return "";
  const std::span shown = std::span(arrays).first(std::min(arrays.size(), kMaxPanels));
  Svg svg(900, kArrayPanel * static_cast<double>(shown.size()));
  double top = 0;
  for (const PopulationHistory& array : shown) {
    drawArray(svg, top, array);
    top += kArrayPanel;
  }
  return svg.take();
}

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
  const auto& [rings, sheets, others] = run.cells;
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

}  // namespace tolman::report
