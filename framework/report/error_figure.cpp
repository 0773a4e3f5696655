// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "report/axes.hpp"
#include "report/figures.hpp"

namespace tolman::report {
namespace {

double highest(const ErrorSeries& series) {
  const auto most = std::max_element(series.metres.begin(), series.metres.end());
  return most == series.metres.end() ? 0 : *most;
}

std::string entry(const char* name, const evaluation::TrajectoryMetrics& metrics) {
  if (!metrics.scores) return name;
  return fmt::format("{}, rmse {:.3f} m", name, metrics.scores->ate_m.rmse);
}

}  // namespace

std::string errorFigure(const RunData& run) {
  if (run.odometry_error.metres.empty() && run.map_error.metres.empty()) return "";
  Range time;
  for (const auto* series : {&run.odometry_error, &run.map_error}) {
    if (!series->seconds.empty()) time.include(series->seconds.back());
  }
  const double most = std::max(highest(run.odometry_error), highest(run.map_error));
  Svg svg(900, 330);
  Axes axes(svg, {"Position error after alignment",
                  "data time (s)",
                  "error (m)",
                  time,
                  {0, std::max(1.05 * most, 1e-3)},
                  frame(70.0, 60.0, 880.0, 280.0)});
  axes.polyline(run.odometry_error.seconds, run.odometry_error.metres, kOrange);
  axes.polyline(run.map_error.seconds, run.map_error.metres, kBlue);
  axes.legend(
      {{kOrange, entry("odometry", run.metrics.odometry)}, {kBlue, entry("map", run.metrics.map)}});
  return svg.take();
}

}  // namespace tolman::report
