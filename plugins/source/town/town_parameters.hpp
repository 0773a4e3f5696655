// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `town`.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "camera_disturbances.hpp"
#include "light.hpp"
#include "street_life.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/parameters.hpp"

namespace tolman::town {

/// Handling of a route whose poses cross at different heights.
enum class Crossings : std::uint8_t { Level, Refuse, Bridge };
inline constexpr std::array<std::string_view, 3> kCrossingsNames = {"level", "refuse", "bridge"};
constexpr std::span<const std::string_view> enumNames(Crossings) { return kCrossingsNames; }

struct TownParameters : FrameSelection, CameraDisturbances, StreetLife {
  // The drive.
  std::string route = "block";
  Crossings crossings = Crossings::Level;
  double rate = 10;
  double speed = 8;
  // The cameras; the defaults are those of KITTI odometry, sequences 00 to 02.
  std::int64_t width = 1241;
  std::int64_t height = 376;
  double fx = 718.856;
  double fy = 718.856;
  double cx = 607.1928;
  double cy = 185.2157;
  double baseline = 0.5372;
  double scale = 1;
  bool mono = false;
  double camera_height = 1.65;
  double camera_pitch = 0;
  double camera_roll = 0;
  bool flight = false;
  // The town.
  std::int64_t seed = 1;
  double aliasing = 0.15;
  double density = 1;
  bool guard_rails = false;
  // Light, weather and image formation: chosen, not tuned.
  double hour = 10.5;  // h
  Weather weather = Weather::Clear;
  double haze = 0.0008;  // 1/m
  std::string conditions;
  double noise = 1;               // of the usual noise
  double vignetting = 0.25;       // share that the corners lose
  double exposure_change = 0.06;  // of the logarithm of the gain
  double motion_blur = 0;
  std::int64_t edge_samples = 2;
  bool depth = false;
  // Disturbances; all off by default.
  double traffic = 0;
  double baseline_error = 0;
  double rotation_error = 0;
  double dropped = 0;
  double corrupt = 0;

  static constexpr auto declaration();
};

namespace detail {

constexpr auto driveParameters() {
  using P = TownParameters;
  return parameters(
      parameter("route", &P::route)
          .doc("block, eights, district, highway, car_park, hall, or a file of poses in KITTI's "
               "format "
               "to drive "
               "along."),
      parameter("crossings", &P::crossings)
          .doc("For a route whose passes cross too far apart in height. level: their heights, and "
               "the true poses, are bent until they agree; bridge: bridges are built where they "
               "cross at an angle, and the rest is levelled; refuse: the route is refused."),
      parameter("rate", &P::rate).range(0.1, 1000).unit("Hz").doc("Frames per second."),
      parameter("speed", &P::speed)
          .range(0.5, 40)
          .unit("m/s")
          .doc("Speed on straight streets of a built-in route; bends are taken slower."));
}

constexpr auto cameraParameters() {
  using P = TownParameters;
  return parameters(
      parameter("width", &P::width).range(32, 8192).unit("px").doc("Image width."),
      parameter("height", &P::height).range(32, 8192).unit("px").doc("Image height."),
      parameter("fx", &P::fx).range(1, 1e5).unit("px").doc("Focal length, horizontal."),
      parameter("fy", &P::fy).range(1, 1e5).unit("px").doc("Focal length, vertical."),
      parameter("cx", &P::cx).range(0, 8192).unit("px").doc("Principal point, horizontal."),
      parameter("cy", &P::cy).range(0, 8192).unit("px").doc("Principal point, vertical."),
      parameter("baseline", &P::baseline)
          .range(0.001, 5)
          .unit("m")
          .doc("Distance of the right camera from the left one."),
      parameter("scale", &P::scale)
          .range(0.05, 4)
          .doc("Resizes image and calibration together: 0.5 renders at half size."),
      parameter("mono", &P::mono).doc("Render the left camera only."),
      parameter("camera_height", &P::camera_height)
          .range(0.5, 4)
          .unit("m")
          .doc("Height of the camera above the road; of a flight, at its first pose."),
      parameter("camera_pitch", &P::camera_pitch)
          .range(-60, 60)
          .unit("deg")
          .doc("How far the camera looks up from the poses of the route."),
      parameter("camera_roll", &P::camera_roll)
          .range(-60, 60)
          .unit("deg")
          .doc(
              "How far the camera is turned to the right about its optical axis, from the poses of "
              "the route."),
      parameter("flight", &P::flight)
          .doc("The camera is flown or carried. A file: streets lie on level ground below the "
               "poses and do not follow their heights. A built-in route: 0 to 4 m above the "
               "first camera, pitching and rolling by 8 degrees."));
}

constexpr auto townParameters() {
  using P = TownParameters;
  return parameters(
      parameter("seed", &P::seed)
          .range(0, 4294967295.0)
          .doc("Seed of houses, trees and textures; camera noise uses the seed of the run."),
      parameter("aliasing", &P::aliasing)
          .range(0, 1)
          .doc("Share of street fronts that look like one of two others."),
      parameter("density", &P::density)
          .range(0, 1)
          .doc("Share of houses, trees and parked cars that are built; 0 leaves bare streets."),
      parameter("guard_rails", &P::guard_rails)
          .doc("Rails on posts every 4 m along both sides of the road, as on highways: each post "
               "looks like the next."));
}

constexpr auto imageParameters() {
  using P = TownParameters;
  return parameters(
      parameter("hour", &P::hour).range(0, 24).unit("h").doc("Time of a summer's day."),
      parameter("weather", &P::weather).doc("clear, overcast, rain or fog."),
      parameter("haze", &P::haze)
          .range(0, 1)
          .unit("1/m")
          .doc("Extinction coefficient of the air; 0.0008 halves the contrast at 870 m."),
      parameter("conditions", &P::conditions)
          .doc("Light, weather and season by part of the drive: 'pass 2 = night; 300-450 m = dusk "
               "rain', with day, dusk, night, clear, overcast, fog, rain, snow, bare, leaf, "
               "exchanged (other parked cars); ranges are 'pass 2', 'pass 2-3', '0-90 m', 'all'."),
      parameter("noise", &P::noise)
          .range(0, 20)
          .doc("Shot and read noise; 1 is about 1.5 grey levels in the mid tones, 0 none."),
      parameter("vignetting", &P::vignetting)
          .range(0, 0.9)
          .doc("Share of light that the corners of the image lose."),
      parameter("exposure_change", &P::exposure_change)
          .range(0, 1)
          .doc("Relative amplitude of slow changes of the gain, the same for both cameras."),
      parameter("motion_blur", &P::motion_blur)
          .range(0, 1)
          .doc("Share of the frame interval that the shutter is open, half of it before the stamp. "
               "The longer of this and the time of exposure_time_ms holds."),
      parameter("edge_samples", &P::edge_samples)
          .range(0, 8)
          .doc("Additional rays for pixels on edges; 0: no anti-aliasing of edges."),
      parameter("depth", &P::depth)
          .doc("Provide the true depth of the left image as the sensor array depth.left."));
}

constexpr auto disturbanceParameters() {
  using P = TownParameters;
  return parameters(
      parameter("traffic", &P::traffic)
          .range(0, 60)
          .unit("1/km")
          .doc("Oncoming cars per kilometre of the route."),
      parameter("baseline_error", &P::baseline_error)
          .range(-0.5, 0.5)
          .doc("Relative error of the calibrated baseline: true / calibrated - 1."),
      parameter("rotation_error", &P::rotation_error)
          .range(0, 5)
          .unit("deg")
          .doc("True rotation of the right camera about each axis, unknown to the calibration."),
      parameter("dropped", &P::dropped).range(0, 0.9).doc("Share of frames that are missing."),
      parameter("corrupt", &P::corrupt).range(0, 0.9).doc("Share of frames that have no image."));
}

}  // namespace detail

constexpr auto TownParameters::declaration() {
  return std::tuple_cat(
      detail::driveParameters(), detail::cameraParameters(), detail::townParameters(),
      detail::imageParameters(), detail::disturbanceParameters(), streetLife<TownParameters>(),
      cameraDisturbances<TownParameters>(), selectionParameters<TownParameters>());
}

}  // namespace tolman::town
