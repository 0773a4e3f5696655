// SPDX-License-Identifier: BSD-3-Clause
// Parameters of a source whose images are messages of ROS: the topics of the cameras, and the
// processing of their images.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <tuple>

#include "given_pinhole.hpp"
#include "tolman/parameters.hpp"

namespace tolman::source_parameters {

/// Base of a source's Parameters.
struct CameraParameters : GivenPinhole {
  std::string left;
  std::string right;
  bool mono = false;
  std::string left_info;
  std::string right_info;
  double tolerance = 0.005;  // s; chosen, not tuned
  bool colour = false;
  int bits = 16;
};

/// Declaration of the topics for a Parameters struct that derives from CameraParameters.
template <std::derived_from<CameraParameters> P>
constexpr auto cameraTopics() {
  return parameters(
      parameter<P, std::string>("left", &P::left)
          .doc("Topic of the left (or only) camera; empty: the only one, or that of a pair."),
      parameter<P, std::string>("right", &P::right)
          .doc("Topic of the right camera; empty: the one whose name belongs to left."),
      parameter<P, bool>("mono", &P::mono).doc("Use the left camera only."),
      parameter<P, std::string>("left_info", &P::left_info)
          .doc("Topic of the left camera's CameraInfo; empty: the one beside its images."),
      parameter<P, std::string>("right_info", &P::right_info)
          .doc("Topic of the right camera's CameraInfo; empty: the one beside its images."));
}

/// Declaration of the other parameters.
template <std::derived_from<CameraParameters> P>
constexpr auto cameraImages(std::string_view tolerance_doc) {
  return std::tuple_cat(
      parameters(parameter<P, double>("tolerance", &P::tolerance)
                     .range(0, 10)
                     .unit("s")
                     .doc(tolerance_doc),
                 parameter<P, bool>("colour", &P::colour)
                     .doc("Provide colour images; otherwise images are converted to grey."),
                 parameter<P, int>("bits", &P::bits)
                     .range(8, 16)
                     .doc("Bits that images of 16 bits use, from the lowest; the 8 highest of them "
                          "are taken.")),
      pinholeParameter<P>("[fx, fy, cx, cy] of rectified images, or [f] about their middle, in "
                          "place of CameraInfo; "
                          "empty: by CameraInfo."),
      baselineParameter<P>());
}

}  // namespace tolman::source_parameters
