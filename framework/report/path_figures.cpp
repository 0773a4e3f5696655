// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "report/axes.hpp"
#include "report/figures.hpp"

namespace tolman::report {
namespace {

std::string entry(const char* name, const evaluation::TrajectoryMetrics& metrics) {
  if (!metrics.scores) return name;
  return fmt::format("{}, rmse {:.3f} m", name, metrics.scores->ate_m.rmse);
}

constexpr double kLevel = 0.1;  // m; heights that differ by less are not drawn

/// The height in metres over the driven distance. In the world frame y is down.
Curve profileOf(const char* colour, const char* name, const evaluation::Trajectory& trajectory,
                double metres) {
  Curve profile{name, colour, evaluation::distances(trajectory), {}};
  for (double& driven : profile.x) driven *= metres;
  for (const auto& pose : trajectory) {
    profile.y.push_back(-pose.T_world_camera.translation().y() * metres);
  }
  return profile;
}

}  // namespace

std::string errorFigure(const RunData& run) {
  if (run.odometry_error.metres.empty() && run.map_error.metres.empty()) return "";
  Svg svg(900, 330);
  plot(svg,
       {"Position error after alignment",
        "data time (s)",
        "error (m)",
        {0, 1},
        {0, 1e-3},
        frame(70.0, 60.0, 880.0, 280.0)},
       {{entry("odometry", run.metrics.odometry), kOrange, run.odometry_error.seconds,
         run.odometry_error.metres},
        {entry("map", run.metrics.map), kBlue, run.map_error.seconds, run.map_error.metres}});
  return svg.take();
}

std::string stepFigure(const RunData& run) {
  std::vector<Curve> lengths;
  std::vector<Curve> turns;
  Range frames = Range::none();
  for (const auto& [name, colour, series] :
       {std::tuple("odometry", kOrange, &run.odometry_error.steps),
        std::tuple("map", kBlue, &run.map_error.steps)}) {
    const std::vector<double> at(series->frames.begin(), series->frames.end());
    for (const double frame : at) frames.include(frame);
    lengths.push_back({name, colour, at, series->log_ratio});
    turns.push_back({"", colour, at, {}});
    for (const double turn : series->turn) turns.back().y.push_back(turn * evaluation::kDegrees);
  }
  if (!(frames.length() > 0)) return "";
  Svg svg(900, 520);
  plot(svg,
       {"Motion against the true motion",
        "frame",
        "ln (length / true length)",
        frames,
        {-0.1, 0.1},
        frame(70.0, 60.0, 880.0, 250.0)},
       lengths);
  plot(svg, {"", "frame", "turn apart (deg)", frames, {0, 0.1}, frame(70.0, 310.0, 880.0, 470.0)},
       turns);
  return svg.take();
}

std::string elevationFigure(const RunData& run) {
  if (run.metrics.alignment == evaluation::Alignment::Se2 || !run.has_metres) return "";
  std::vector<Curve> profiles;
  if (!run.truth.empty()) {
    profiles.push_back(profileOf(kGrey, "truth", run.truth, run.metres));
    profiles.back().thickness = 4;
  }
  profiles.push_back(profileOf(kOrange, "odometry", run.odometry, run.metres));
  profiles.push_back(profileOf(kBlue, "map", run.map, run.metres));
  Range driven{0, 0};
  Range height{0, 0};
  for (const Curve& profile : profiles) {
    for (const double x : profile.x) driven.include(x);
    for (const double y : profile.y) height.include(y);
  }
  if (height.length() < kLevel || !(driven.length() > 0)) return "";
  Svg svg(900, 330);
  plot(svg,
       {"Height along the path", "distance driven (m)", "height (m)", driven, Range::none(),
        frame(70.0, 60.0, 880.0, 280.0)},
       profiles);
  return svg.take();
}

std::string templateFigure(const std::vector<PlaceObservation>& places) {
  Range time;
  Range templates;
  for (const PlaceObservation& place : places) {
    if (place.recognition == Recognition::None) continue;
    time.include(static_cast<double>(place.stamp_ns - places.front().stamp_ns) * 1e-9);
    templates.include(static_cast<double>(place.template_id));
  }
  if (places.empty()) return "";
  Svg svg(900, 380);
  Axes axes(svg, {"Local view template over time", "data time (s)", "template", time, templates,
                  frame(70.0, 60.0, 880.0, 330.0)});
  // Draws novel ones last, because the familiar ones after each would cover it.
  for (const Recognition kind : {Recognition::Familiar, Recognition::Novel}) {
    Eigen::Vector2d last(-1, -1);
    for (const PlaceObservation& place : places) {
      if (place.recognition != kind) continue;
      const double seconds = static_cast<double>(place.stamp_ns - places.front().stamp_ns) * 1e-9;
      const Eigen::Vector2d at = axes.at(seconds, static_cast<double>(place.template_id));
      if ((at - last).norm() < 0.2) continue;  // as if it were drawn
      svg.circle(at, 1.6, kind == Recognition::Novel ? kBlue : kVermilion);
      last = at;
    }
  }
  axes.legend({{kBlue, "novel"}, {kVermilion, "familiar"}});
  return svg.take();
}

std::string timingFigure(const evaluation::Metrics& metrics) {
  if (metrics.timing.empty()) return "";
  double most = 0;
  for (const auto& [stage, timing] : metrics.timing) most = std::max(most, timing.p90_ms);
  const double height = 30.0 * static_cast<double>(metrics.timing.size());
  Svg svg(900, height + 120);
  Axes axes(svg, {"Time of a frame",
                  "ms",
                  "",
                  {0, std::max(1.15 * most, 1e-3)},
                  {0, 1},
                  frame(110.0, 60.0, 880.0, 60.0 + height)});
  double y = 60;
  for (const auto& [stage, timing] : metrics.timing) {
    svg.rectangle({110, y + 5}, {axes.pixelsX(timing.p90_ms), 20}, kPaleBlue);
    svg.rectangle({110, y + 5}, {axes.pixelsX(timing.median_ms), 20}, kBlue);
    svg.text({102, y + 19}, stage, {TextAnchor::End});
    svg.text({116 + axes.pixelsX(timing.p90_ms), y + 19},
             fmt::format("{:.3g} / {:.3g}", timing.median_ms, timing.p90_ms),
             {TextAnchor::Start, 11});
    y += 30;
  }
  axes.legend({{kBlue, "median"}, {kPaleBlue, "90th percentile"}});
  return svg.take();
}

}  // namespace tolman::report
