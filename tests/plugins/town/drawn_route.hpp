// SPDX-License-Identifier: BSD-3-Clause
// Routes that tests draw: a lane path, one pose a metre, over ground of any shape.
#pragma once

#include <functional>

#include "lane_path.hpp"
#include "route.hpp"

namespace tolman::town::test {

/// Height of the camera after s metres.
using HeightAt = std::function<double(double s)>;

inline Eigen::Isometry3d levelPose(const LanePosition& lane, double height) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  const Eigen::Vector2d& d = lane.direction;
  T.linear() << d.y(), 0, d.x(), -d.x(), 0, d.y(), 0, -1, 0;
  T.translation() << lane.position, height;
  return T;
}

inline CameraRoute drawnRoute(
    const LanePath& path, const HeightAt& height = [](double) { return 0.0; }) {
  CameraRoute route;
  route.name = "drawn";
  for (double s = 0; s <= path.length() + 1e-9; s += 1) {
    route.stamps_ns.push_back(static_cast<std::int64_t>(s * 1e8));
    route.T_town_camera.push_back(levelPose(path.at(s), height(s)));
  }
  return route;
}

inline CameraRoute builtIn(std::string_view name, double rate = 10) {
  RouteOptions options;
  options.rate = rate;
  return builtInRoute(name, options).value();
}

}  // namespace tolman::town::test
