// SPDX-License-Identifier: BSD-3-Clause
// Parameters of a source of live images, the same for ROS 1 and ROS 2.
#pragma once

#include <string>
#include <tuple>

#include "message_cameras.hpp"
#include "tolman/parameters.hpp"

namespace tolman::live_images {

/// Base of the Parameters.
struct LiveParameters : source_parameters::CameraParameters {
  std::string depth;
  std::string imu;
  std::string odometry;
  double wait = 5;
  bool end_when_silent = false;
  std::int64_t last = -1;
  std::int64_t step = 1;
};

template <std::derived_from<LiveParameters> P>
constexpr auto liveParameters() {
  return std::tuple_cat(
      source_parameters::cameraTopics<P>(),
      parameters(
          parameter<P, std::string>("depth", &P::depth)
              .doc("Topic of depth images for the sensor depth; empty: none."),
          parameter<P, std::string>("imu", &P::imu)
              .doc("Topic for the sensors imu.*; empty: none."),
          parameter<P, std::string>("odometry", &P::odometry)
              .doc("Topic for the sensor motion.planar; empty: none."),
          parameter<P, double>("wait", &P::wait)
              .range(0.1, 3600)
              .unit("s")
              .doc("Longest time to wait for topics, for the first image, and for each other."),
          parameter<P, bool>("end_when_silent", &P::end_when_silent)
              .doc("The run ends well when no image came for that time, as after a replayed bag; "
                   "otherwise that is a failure."),
          parameter<P, std::int64_t>("last", &P::last)
              .range(-1, 1e9)
              .doc("Last image to use, from 0; -1 for as many as come."),
          parameter<P, std::int64_t>("step", &P::step)
              .range(1, 1e9)
              .doc("Use every step-th image.")),
      source_parameters::cameraImages<P>(
          "Largest difference between the stamps of a stereo pair, or of depth and image."));
}

}  // namespace tolman::live_images
