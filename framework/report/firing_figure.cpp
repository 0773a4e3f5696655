// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "report/axes.hpp"
#include "report/colour_map.hpp"
#include "report/figures.hpp"
#include "report/firing_rate.hpp"
#include "tolman/geometry.hpp"

namespace tolman::report {
namespace {

constexpr int kMostBins = 70;
constexpr double kFarthest = 1e7;  // m
constexpr double kPanel = 430;     // px

/// The path of the map with the rate of one unit on it.
std::vector<Sample> samplesOf(const PopulationHistory& population, std::size_t unit,
                              const evaluation::Trajectory& map) {
  std::map<std::int64_t, const Eigen::Isometry3d*> poses;
  for (const auto& pose : map) poses[pose.frame] = &pose.T_world_camera;
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < population.frames.size(); ++i) {
    const auto pose = poses.find(population.frames[i]);
    if (pose == poses.end() || unit >= population.activity[i].size()) continue;
    const Eigen::Vector3d p = pose->second->translation();
    if (!(p.cwiseAbs().maxCoeff() < kFarthest)) continue;  // a map that has run away
    samples.push_back(
        {{p.x(), p.z()}, toPlanar(*pose->second).theta, population.activity[i][unit]});
  }
  return samples;
}

/// Bins that steps do not jump over, or every visit would be a field of its own.
int binsFor(const std::vector<Sample>& samples) {
  Eigen::AlignedBox2d box;
  double way = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    box.extend(samples[i].position);
    if (i > 0) way += (samples[i].position - samples[i - 1].position).norm();
  }
  const double step = way / std::max(static_cast<double>(samples.size()) - 1, 1.0);
  if (!(step > 0)) return 1;
  return std::clamp(static_cast<int>(box.sizes().maxCoeff() / (1.5 * step)), 1, kMostBins);
}

RateMap ratesOf(const std::vector<Sample>& samples) { return rateMap(samples, binsFor(samples)); }

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

/// The grid unit of phase (0, 0), each of its fields in a ring.
void drawGridUnit(Svg& svg, const RateMap& rates) {
  constexpr double kRing = 14;  // px
  const std::vector<Eigen::Vector2d> centres = fields(rates);
  const Axes axes =
      drawRates(svg, {0, kPanel},
                fmt::format("grid unit (1, 1): {} field{}, {:.2f} bits", centres.size(),
                            centres.size() == 1 ? "" : "s", spatialInformation(rates)),
                rates);
  for (const Eigen::Vector2d& centre : centres) {
    svg.circle(axes.at(centre.x(), centre.y()), kRing, "none", kVermilion);
  }
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
  axes.legend(
      {{kBlue, fmt::format("mean vector length {:.2f} towards {:.0f} deg", curve.mean_vector_length,
                           curve.preferred * 180 / std::numbers::pi)}});
}

void drawRingUnits(Svg& svg, const PopulationHistory& ring, const evaluation::Trajectory& map) {
  const auto opposite = static_cast<std::size_t>(ring.shape[0]) / 2;
  for (const std::size_t unit : {std::size_t{0}, opposite}) {
    const RateMap rates = ratesOf(samplesOf(ring, unit, map));
    drawRates(svg, {unit == 0 ? 0 : kPanel, 0},
              fmt::format("head direction unit {} of {}, {} deg", unit + 1, ring.shape[0],
                          360 * unit / static_cast<std::size_t>(ring.shape[0])),
              rates);
  }
  drawTuning(svg, {kPanel, kPanel}, "tuning of head direction unit 1",
             tuningCurve(samplesOf(ring, 0, map), 36));
}

}  // namespace

std::string firingFigure(const CellHistory& cells, const evaluation::Trajectory& map) {
  if ((cells.ring.empty() && cells.sheet.empty()) || map.empty()) return "";
  Svg svg(2 * kPanel, 2 * kPanel);
  if (!cells.ring.empty()) drawRingUnits(svg, cells.ring, map);
  if (!cells.sheet.empty()) {
    drawGridUnit(svg, ratesOf(samplesOf(cells.sheet, 0, map)));
  }
  return svg.take();
}

}  // namespace tolman::report
