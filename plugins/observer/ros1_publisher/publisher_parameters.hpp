// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the observer `ros1_publisher`, the same with and without ROS in the build.
#pragma once

#include <string>

#include "tolman/parameters.hpp"

namespace tolman::ros1_publisher {

struct PublisherParameters {
  std::string master;
  std::string prefix = "/tolman";
  std::string map_frame = "map";
  std::string camera_frame = "tolman_camera";
  bool tf = true;
  double every = 1;

  static constexpr auto declaration() {
    using P = PublisherParameters;
    return parameters(
        parameter("master", &P::master)
            .doc("URI of the roscore; empty: $ROS_MASTER_URI, or http://localhost:11311."),
        parameter("prefix", &P::prefix).doc("The topics are PREFIX/pose, PREFIX/path, PREFIX/map."),
        parameter("map_frame", &P::map_frame)
            .doc("Name of the map's frame: x forward, y left, z up at the first image."),
        parameter("camera_frame", &P::camera_frame)
            .doc("Name of the camera's frame, with z along the optical axis."),
        parameter("tf", &P::tf).doc("Publish the camera's pose in /tf, too."),
        parameter("every", &P::every)
            .range(0, 3600)
            .unit("s")
            .doc("Path and map are published at most once in this time, and at the end."));
  }
};

}  // namespace tolman::ros1_publisher
