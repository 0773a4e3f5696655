// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the observer `ros2_publisher`, the same with and without DDS in the build.
#pragma once

#include <string>
#include <tuple>

#include "ros2_network.hpp"

namespace tolman::ros2_publisher {

struct PublisherParameters : source_parameters::Ros2Network {
  std::string prefix = "/tolman";
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string camera_frame = "tolman_camera";
  bool tf = true;
  double every = 1;

  static constexpr auto declaration();
};

constexpr auto PublisherParameters::declaration() {
  using P = PublisherParameters;
  return std::tuple_cat(
      source_parameters::ros2Network<P>(),
      parameters(
          parameter("prefix", &P::prefix)
              .doc("The topics are PREFIX/odometry, PREFIX/path, PREFIX/map."),
          parameter("map_frame", &P::map_frame)
              .doc("Frame of the map: x forward, y left, z up at the first image."),
          parameter("odom_frame", &P::odom_frame)
              .doc("Frame of the odometry, which never jumps; in the map it does where loops "
                   "close."),
          parameter("camera_frame", &P::camera_frame)
              .doc("Frame of the camera, x forward; with _optical behind it z is forward."),
          parameter("tf", &P::tf).doc("Publish the frames in /tf, too."),
          parameter("every", &P::every)
              .range(0, 3600)
              .unit("s")
              .doc("Path, map and state are published at most once in this time, and at the "
                   "end.")));
}

}  // namespace tolman::ros2_publisher
