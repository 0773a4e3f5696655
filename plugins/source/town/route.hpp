// SPDX-License-Identifier: BSD-3-Clause
// The route of the car: one camera pose and one stamp per frame.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::town {

/// A level rectangle of the ground under a building.
struct GroundPad {
  Eigen::Vector2d low;   ///< m, town frame
  Eigen::Vector2d high;  ///< m
  double height = 0;     ///< m
};

/// The building that a route leads through.
enum class Building : std::uint8_t { None, CarPark, Hall };

struct CameraRoute {
  std::string name;
  std::vector<std::int64_t> stamps_ns;
  /// Left camera (x right, y down, z forward) to town axes (see world.hpp); the first is the
  /// origin, looking along Y.
  std::vector<Eigen::Isometry3d> T_town_camera;
  /// Whether each frame is on a floor of the car park, whose height is not used for streets and
  /// terrain. Empty: no frame.
  std::vector<bool> raised;
  std::vector<GroundPad> pads;
  Building building = Building::None;
  bool is_highway = false;  ///< guard rails and open land

  bool isRaised(std::size_t frame) const { return frame < raised.size() && raised[frame]; }
  /// Adds the next frame at `rate` frames a second.
  void add(const Eigen::Isometry3d& pose, double rate) {
    const auto frame = static_cast<double>(stamps_ns.size());
    stamps_ns.push_back(std::llround(frame * 1e9 / rate));
    T_town_camera.push_back(pose);
  }
};

struct RouteOptions {
  double rate = 10;             ///< frames a second
  double speed = 8;             ///< m/s on straight streets; built-in routes slow down in bends
  double camera_height = 1.65;  ///< m above the road
};

/// `block` (about 300 m, once round and beyond the start: one loop), `eights`, `district`,
/// `highway`, `car_park` (five floors, up and down twice), `hall` (hand-held). Other names are
/// InvalidParameter; the message lists these.
Result<CameraRoute> builtInRoute(std::string_view name, const RouteOptions& options);

/// Reads a KITTI pose file: T_world_camera as twelve numbers per line. Refuses an empty file, a
/// line without twelve finite numbers, a matrix that is not a rotation, and poses too far apart for
/// a drive. The message has file, line, error and remedy.
Result<CameraRoute> readRoute(const std::filesystem::path& file, const RouteOptions& options);

/// At the origin; azimuth from Y to X, rad.
Eigen::Isometry3d levelPose(double azimuth);

/// A flight along the same streets, 0 to 4 m above the first camera as a function of the place.
/// Pitch and roll of up to 8 degrees are functions of time, so they differ between passes.
CameraRoute flown(const CameraRoute& driven);

/// The same path on level ground at the height of the first pose, without pitch and roll.
CameraRoute groundTrack(const CameraRoute& route);

}  // namespace tolman::town
