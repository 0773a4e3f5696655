// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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

constexpr double kLevel = 0.1;  // m; heights that differ by less are not drawn

struct Profile {
  const char* colour;
  double thickness;
  const char* name;
  std::vector<double> driven;  ///< m
  std::vector<double> height;  ///< m
};

/// Heights in metres. In the world frame y is down, so the sign is changed.
Profile profileOf(const char* colour, const char* name, const evaluation::Trajectory& trajectory,
                  double metres) {
  const double thickness = colour == kGrey ? 4 : 1.5;
  Profile profile{colour, thickness, name, evaluation::distances(trajectory), {}};
  for (double& driven : profile.driven) driven *= metres;
  for (const auto& pose : trajectory) {
    profile.height.push_back(-pose.T_world_camera.translation().y() * metres);
  }
  return profile;
}

Range rangeOf(const std::vector<Profile>& profiles, std::vector<double> Profile::*values) {
  Range range{0, 0};
  for (const Profile& profile : profiles) {
    for (const double value : profile.*values) range.include(value);
  }
  return range;
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

std::string stepFigure(const RunData& run) {
  const std::array series = {&run.odometry_error.steps, &run.map_error.steps};
  Range frames{HUGE_VAL, -HUGE_VAL}, ratios{-0.1, 0.1}, turns{0, 0.1};
  std::array<std::vector<double>, 2> at, turned;
  for (std::size_t i = 0; i < series.size(); ++i) {
    at[i].assign(series[i]->frames.begin(), series[i]->frames.end());
    for (const double turn : series[i]->turn) turned[i].push_back(turn * evaluation::kDegrees);
    for (const double frame : at[i]) frames.include(frame);
    for (const double ratio : series[i]->log_ratio) ratios.include(ratio);
    for (const double turn : turned[i]) turns.include(turn);
  }
  if (!(frames.length() > 0)) return "";
  Svg svg(900, 520);
  Axes lengths(svg, {"Motion against the true motion", "frame", "ln (length / true length)", frames,
                     ratios, frame(70.0, 60.0, 880.0, 250.0)});
  Axes angles(svg,
              {"", "frame", "turn apart (deg)", frames, turns, frame(70.0, 310.0, 880.0, 470.0)});
  for (std::size_t i = 0; i < series.size(); ++i) {
    const char* colour = i == 0 ? kOrange : kBlue;
    lengths.polyline(at[i], series[i]->log_ratio, colour);
    angles.polyline(at[i], turned[i], colour);
  }
  lengths.legend({{kOrange, "odometry"}, {kBlue, "map"}});
  return svg.take();
}

std::string elevationFigure(const RunData& run) {
  if (run.metrics.alignment == evaluation::Alignment::Se2 || !run.has_metres) return "";
  std::vector<Profile> profiles;
  if (!run.truth.empty()) profiles.push_back(profileOf(kGrey, "truth", run.truth, run.metres));
  profiles.push_back(profileOf(kOrange, "odometry", run.odometry, run.metres));
  profiles.push_back(profileOf(kBlue, "map", run.map, run.metres));
  const Range driven = rangeOf(profiles, &Profile::driven);
  Range height = rangeOf(profiles, &Profile::height);
  if (height.length() < kLevel || !(driven.length() > 0)) return "";
  const double margin = 0.05 * height.length();
  height = {height.low - margin, height.high + margin};
  Svg svg(900, 330);
  Axes axes(svg, {"Height along the path", "distance driven (m)", "height (m)", driven, height,
                  frame(70.0, 60.0, 880.0, 280.0)});
  std::vector<Axes::LegendEntry> entries;
  for (const Profile& profile : profiles) {
    axes.polyline(profile.driven, profile.height, profile.colour, profile.thickness);
    entries.push_back({profile.colour, profile.name});
  }
  axes.legend(entries);
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
    for (const PlaceObservation& place : places) {
      if (place.recognition != kind) continue;
      const double seconds = static_cast<double>(place.stamp_ns - places.front().stamp_ns) * 1e-9;
      svg.circle(axes.at(seconds, static_cast<double>(place.template_id)), 1.6,
                 kind == Recognition::Novel ? kBlue : kVermilion);
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
