// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `ros_bag`.
#pragma once

#include <string>
#include <tuple>

#include "given_pinhole.hpp"
#include "on_corrupt.hpp"
#include "tolman/frame_selection.hpp"

namespace tolman::ros_bag {

using source_parameters::GivenPinhole;
using source_parameters::OnCorrupt;

struct BagParameters : FrameSelection, GivenPinhole {
  std::string path;
  std::string left;
  std::string right;
  bool mono = false;
  std::string left_info;
  std::string right_info;
  std::string depth;
  std::string imu;
  std::string odometry;
  double tolerance = 0.005;
  bool colour = false;
  OnCorrupt on_corrupt = OnCorrupt::Stop;

  static constexpr auto declaration();
};

constexpr auto topicParameters() {
  using P = BagParameters;
  return parameters(
      parameter("path", &P::path).path().required().doc("Folder of the bag, or one of its files."),
      parameter("left", &P::left)
          .doc("Topic of the left (or only) camera; empty: the only one, or that of a pair."),
      parameter("right", &P::right)
          .doc("Topic of the right camera; empty: the one whose name belongs to left."),
      parameter("mono", &P::mono).doc("Use the left camera only."),
      parameter("left_info", &P::left_info)
          .doc("Topic of the left camera's CameraInfo; empty: the one beside its images."),
      parameter("right_info", &P::right_info)
          .doc("Topic of the right camera's CameraInfo; empty: the one beside its images."),
      parameter("depth", &P::depth)
          .doc(
              "Topic of depth images (16UC1 in mm, 32FC1 in m) for the sensor depth; empty: none."),
      parameter("imu", &P::imu)
          .doc("Topic for the sensors imu.*; empty: the only one of its type, if there is one."),
      parameter("odometry", &P::odometry)
          .doc("Topic for the sensor motion.planar; empty: the only one of its type, if there is "
               "one."));
}

constexpr auto BagParameters::declaration() {
  using P = BagParameters;
  return std::tuple_cat(
      topicParameters(),
      parameters(
          parameter("tolerance", &P::tolerance)
              .range(0, 10)
              .unit("s")
              .doc(
                  "Largest difference between the stamps of a stereo pair, or of depth and image."),
          parameter("colour", &P::colour)
              .doc("Provide colour images; otherwise images are converted to grey."),
          parameter("on_corrupt", &P::on_corrupt)
              .doc("Damaged bags and images: stop, or skip: use what can be read.")),
      source_parameters::pinholeParameters<P>(
          "Focal length of rectified images, in place of CameraInfo; 0: by CameraInfo.",
          "Distance of the right camera from the left one, with fx."),
      selectionParameters<P>());
}

}  // namespace tolman::ros_bag
