// SPDX-License-Identifier: BSD-3-Clause
// The route of the car: one camera pose and one stamp per frame.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::town {

/// A rectangle of the ground that is level, under a building.
struct GroundPad {
  Eigen::Vector2d low;   ///< m, town frame
  Eigen::Vector2d high;  ///< m
  double height = 0;     ///< m
};

struct CameraRoute {
  std::string name;
  std::vector<std::int64_t> stamps_ns;
  /// Left camera (x right, y down, z forward) to town axes (see mesh.hpp); the first is the
  /// origin, looking along Y.
  std::vector<Eigen::Isometry3d> T_town_camera;
  /// Of each frame, whether it is on a deck: a bridge, or a floor of the car park. Neither streets
  /// nor terrain take their heights from it. Empty: none is.
  std::vector<bool> raised;
  std::vector<GroundPad> pads;

  bool isRaised(std::size_t frame) const { return frame < raised.size() && raised[frame]; }
};

struct RouteOptions {
  double rate = 10;             ///< frames a second
  double speed = 8;             ///< m/s on straight streets; built-in routes slow down in bends
  double camera_height = 1.65;  ///< m above the road
};

/// `block` (about 300 m, once round and on over the start: one loop), `eights`, `district`,
/// `highway`, `car_park` (five floors, up and down twice); else InvalidParameter that names them.
Result<CameraRoute> builtInRoute(std::string_view name, const RouteOptions& options);

/// A KITTI pose file: twelve numbers a line, T_world_camera. Refuses an empty file, a line that is
/// not twelve finite numbers, a matrix that is no rotation, and neighbours too far apart to be a
/// drive (file:line, what is wrong, remedy).
Result<CameraRoute> readRoute(const std::filesystem::path& file, const RouteOptions& options);

}  // namespace tolman::town
