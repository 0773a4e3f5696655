// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `town`.
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "tolman/frame_selection.hpp"
#include "tolman/parameters.hpp"

namespace tolman::town {

/// A value of a list, 0 beyond its end.
inline double itemOf(const std::vector<double>& list, std::size_t i) {
  return i < list.size() ? list[i] : 0;
}

struct TownParameters : FrameSelection {
  // The drive.
  std::string route = "block";
  double rate = 10;
  double speed = 8;
  bool flight = false;
  // The cameras; the defaults are those of KITTI odometry, sequences 00 to 02.
  std::vector<double> camera = {1241, 376, 718.856, 718.856, 607.1928, 185.2157, 0.5372};
  double scale = 1;
  bool mono = false;
  std::vector<double> mount = {1.65, 0, 0};
  std::vector<double> rig_error;
  double camera_error = 0;
  // The town.
  std::int64_t seed = 1;
  double aliasing = 0.15;
  double traffic = 0;
  std::string conditions;
  // The images.
  std::vector<double> exposure_ms = {0};
  double exposure_change = 0.06;
  double noise = 1;
  double faults = 0;
  bool depth = false;

  // Lists by name.
  double cameraHeight() const { return mount[0]; }
  double focalError() const { return itemOf(rig_error, 0); }
  double baselineError() const { return itemOf(rig_error, 1); }
  double readoutMs() const { return itemOf(rig_error, 5); }

  static constexpr auto declaration();
};

namespace detail {

constexpr auto driveParameters() {
  using P = TownParameters;
  return parameters(
      parameter("route", &P::route)
          .doc("block, eights, district, highway, car_park, hall, or a file of poses in KITTI's "
               "format to drive along."),
      parameter("rate", &P::rate).range(0.1, 1000).unit("Hz").doc("Frames per second."),
      parameter("speed", &P::speed)
          .range(0.5, 40)
          .unit("m/s")
          .doc("Speed on straight streets of a built-in route; bends are taken slower."),
      parameter("flight", &P::flight)
          .doc("The camera is flown or carried. A file: streets lie on level ground below the "
               "poses and do not follow their heights. A built-in route: 0 to 4 m above the "
               "first camera, pitching and rolling by 8 degrees."));
}

constexpr auto rigParameters() {
  using P = TownParameters;
  return parameters(
      parameter("camera", &P::camera)
          .range(0.001, 1e5)
          .doc("[width, height, fx, fy, cx, cy, baseline]: image size, focal lengths and principal "
               "point in px, distance of the right camera in m."),
      parameter("scale", &P::scale)
          .range(0.05, 4)
          .doc("Resizes image and calibration together: 0.5 renders at half size."),
      parameter("mono", &P::mono).doc("Render the left camera only."),
      parameter("mount", &P::mount)
          .range(-60, 60)
          .doc("[height, pitch, roll]: m of the camera above the road (of a flight, at its first "
               "pose), degrees up and to the right from the poses of the route."),
      parameter("rig_error", &P::rig_error)
          .range(-100, 100)
          .doc("True minus calibrated values: [focal length and baseline, relative; yaw, pitch and "
               "roll of the right camera, degrees to the right, up, clockwise; time from the first "
               "row to the last of a rolling shutter, ms]. What is not given is 0."),
      parameter("camera_error", &P::camera_error)
          .range(0, 10)
          .doc("Other errors of the cameras: 0 exact, 1 as on a road: 0.3 px of residual "
               "distortion, 0.2 px of the principal points, gains that differ by 5 %, corners 5 "
               "and 10 % darker, bloom. At scale 1."));
}

constexpr auto sceneParameters() {
  using P = TownParameters;
  return parameters(
      parameter("seed", &P::seed)
          .range(0, 4294967295.0)
          .doc("Seed of houses, trees and textures; camera noise uses the seed of the run."),
      parameter("aliasing", &P::aliasing)
          .range(0, 1)
          .doc("Share of street fronts that look like one of two others."),
      parameter("traffic", &P::traffic)
          .range(0, 60)
          .unit("1/km")
          .doc("Oncoming cars per kilometre of the route."),
      parameter("conditions", &P::conditions)
          .doc("Light, weather and season, of all of the drive or of passes over the same street: "
               "'dusk rain', 'pass 2-9 = night; pass 3 = 18:00 snow', with a time of a summer's "
               "day, dusk, night, overcast, haze, rain, snow, bare (trees without leaves), "
               "exchanged (other parked cars)."));
}

constexpr auto imageParameters() {
  using P = TownParameters;
  return parameters(
      parameter("exposure_ms", &P::exposure_ms)
          .range(0, 1000)
          .doc("[t]: exposure time in ms, during which images blur; 0 is sharp. [t, longest]: t in "
               "the sun of a clear noon, longer with less light; where the longest does not "
               "suffice, the camera amplifies the signal with its noise."),
      parameter("exposure_change", &P::exposure_change)
          .range(0, 1)
          .doc("Relative amplitude of slow changes of the gain, the same for both cameras."),
      parameter("noise", &P::noise)
          .range(0, 20)
          .doc("Shot and read noise; 1 is about 1.5 grey levels in the mid tones, 0 none."),
      parameter("faults", &P::faults)
          .range(0, 0.9)
          .doc("Share of frames that are missing, and of frames that have no image."),
      parameter("depth", &P::depth)
          .doc("Provide the true depth of the left image as the sensor array depth.left."));
}

}  // namespace detail

constexpr auto TownParameters::declaration() {
  return std::tuple_cat(detail::driveParameters(), detail::rigParameters(),
                        detail::sceneParameters(), detail::imageParameters(),
                        selectionParameters<TownParameters>());
}

}  // namespace tolman::town
