// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `ros_bag`.
#pragma once

#include <string>
#include <tuple>

#include "message_cameras.hpp"
#include "tolman/frame_selection.hpp"

namespace tolman::ros_bag {

struct BagParameters : FrameSelection, source_parameters::CameraParameters {
  std::string path;
  std::string depth;
  std::string imu;
  std::string odometry;
  std::string truth;

  static constexpr auto declaration();
};

constexpr auto sensorTopics() {
  using P = BagParameters;
  return parameters(
      parameter("depth", &P::depth)
          .doc("Topic of depth images (16UC1 in mm, 32FC1 in m, also compressed) for the sensor "
               "depth; "
               "empty: none."),
      parameter("imu", &P::imu)
          .doc("Topic for the sensors imu.*; empty: the only one of its type, if there is one."),
      parameter("odometry", &P::odometry)
          .doc("Topic for the sensor motion.planar; empty: the only one of its type, if there is "
               "one."),
      parameter("truth", &P::truth)
          .doc("Topic of true poses (Odometry, PoseStamped, PoseWithCovarianceStamped, "
               "TransformStamped), or of tf with its frames: `/tf world camera`."));
}

constexpr auto BagParameters::declaration() {
  using P = BagParameters;
  return std::tuple_cat(
      parameters(parameter("path", &P::path)
                     .path()
                     .required()
                     .doc("Folder of the bag, or one of its files.")),
      source_parameters::cameraTopics<P>(), sensorTopics(),
      source_parameters::cameraImages<P>(
          "Largest difference between the stamps of a stereo pair, or of depth and image."),
      selectionParameters<P>());
}

}  // namespace tolman::ros_bag
