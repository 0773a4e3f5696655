// SPDX-License-Identifier: BSD-3-Clause
// Parameters of feature_stereo and feature_rgbd.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::feature_stereo {

/// The defaults were chosen on KITTI 06, raw 0001 and the town along KITTI 07; how is not recorded.
struct Parameters {
  int corners = 500;
  double offset_sigma = 0.2;
  int window = 7;
  double keyframe_flow = 15;

  template <class P>
  static constexpr auto cornerParameters() {
    return tolman::parameters(
        parameter<P, int>("corners", &P::corners)
            .range(50, 5000)
            .doc("Number of corners that are tracked, one per cell of a grid over the image."));
  }
  /// Keyframes and the window.
  template <class P>
  static constexpr auto windowParameters() {
    return tolman::parameters(
        parameter<P, int>("window", &P::window)
            .range(2, 30)
            .unit("keyframes")
            .doc("Keyframes that are refined together."),
        parameter<P, double>("keyframe_flow", &P::keyframe_flow)
            .range(0.5, 1000)
            .unit("px")
            .doc("Median image motion since the last keyframe at which a new one is made."));
  }

  static constexpr auto declaration() {
    using P = Parameters;
    return std::tuple_cat(
        cornerParameters<P>(),
        tolman::parameters(
            parameter("offset_sigma", &P::offset_sigma)
                .range(0, 5)
                .unit("px")
                .doc("Standard deviation of an offset that all disparities share, which is "
                     "estimated; 0: no offset.")),
        windowParameters<P>());
  }
};

/// Of a single camera with depth images.
struct RgbdParameters : Parameters {
  double depth_noise = 0.0015;  // 1/m; of structured light (Khoshelham and Elberink, Sensors 2012)

  static constexpr auto declaration() {
    using P = RgbdParameters;
    return std::tuple_cat(
        cornerParameters<P>(),
        tolman::parameters(
            parameter<P, double>("depth_noise", &P::depth_noise)
                .range(1e-6, 1)
                .unit("1/m")
                .doc("Standard deviation of a measured depth, divided by the square of the depth: "
                     "that of structured light and of stereo cameras grows so.")),
        windowParameters<P>());
  }
};

}  // namespace tolman::feature_stereo
