// SPDX-License-Identifier: BSD-3-Clause
#include "report/axes.hpp"
#include "report/figures.hpp"

namespace tolman::report {
namespace {

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

}  // namespace tolman::report
