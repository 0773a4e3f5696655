// SPDX-License-Identifier: BSD-3-Clause
// Parameters of feature_stereo and feature_rgbd.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::feature_stereo {

/// Where nothing else is said, the defaults were chosen on KITTI 06, raw 0001 and the town along
/// KITTI 07; how is not recorded.
struct Parameters {
  int corners = 500;
  double corner_quality = 0.003;
  int track_window = 15;
  int track_levels = 3;
  double track_consistency = 0.7;
  double stereo_consistency = 0.7;
  double nearest = 2.5;  // m; bounds the search
  double sigma_track = 0.25;
  double sigma_disparity = 0.15;
  double sigma_doubling = 14;   // px; one for tracks and disparities on KITTI (projection.hpp)
  int ransac_iterations = 100;  // bounds the time
  int min_inliers = 20;
  int window = 7;
  double keyframe_flow = 15;
  double keyframe_survival = 0.75;
  int refinement_iterations = 6;  // three are worse where 06 is blurred
  double offset_sigma = 0.2;

  /// Corners, their tracking, and its accuracy.
  template <class P>
  static constexpr auto cornerParameters() {
    return tolman::parameters(
        parameter<P, int>("corners", &P::corners)
            .range(50, 5000)
            .doc("Number of corners that are tracked, one per cell of a grid over the image."),
        parameter<P, double>("corner_quality", &P::corner_quality)
            .range(1e-6, 1)
            .doc("Smallest corner response, relative to the strongest one of the image."),
        parameter<P, int>("track_window", &P::track_window)
            .range(7, 61)
            .unit("px")
            .doc("Side of the patch that is tracked; odd."),
        parameter<P, int>("track_levels", &P::track_levels)
            .range(1, 8)
            .doc("Levels of the image pyramid, each half as wide as the one before."),
        parameter<P, double>("track_consistency", &P::track_consistency)
            .range(0.05, 10)
            .unit("px")
            .doc("Largest forward-backward error of a corner tracked to the new image."),
        parameter<P, double>("sigma_track", &P::sigma_track)
            .range(0.01, 10)
            .unit("px")
            .doc("Standard deviation of a tracked far corner, in each direction."));
  }
  /// Poses, keyframes and the window.
  template <class P>
  static constexpr auto poseParameters() {
    return tolman::parameters(
        parameter<P, int>("ransac_iterations", &P::ransac_iterations)
            .range(1, 10000)
            .doc("Maximum number of RANSAC samples of three points."),
        parameter<P, int>("min_inliers", &P::min_inliers)
            .range(6, 1000)
            .doc("Fewest inliers of a pose; with fewer, tracking is lost."),
        parameter<P, int>("window", &P::window)
            .range(2, 30)
            .unit("keyframes")
            .doc("Keyframes that are refined together."),
        parameter<P, double>("keyframe_flow", &P::keyframe_flow)
            .range(0.5, 1000)
            .unit("px")
            .doc("Median image motion since the last keyframe at which a new one is made."),
        parameter<P, double>("keyframe_survival", &P::keyframe_survival)
            .range(0.05, 1)
            .doc("A keyframe is made when less than this share of the corners is left."),
        parameter<P, int>("refinement_iterations", &P::refinement_iterations)
            .range(0, 100)
            .doc("Steps of the window refinement at a keyframe; 0 switches it off."));
  }
  /// What the right image adds.
  template <class P>
  static constexpr auto stereoParameters() {
    return tolman::parameters(
        parameter<P, double>("stereo_consistency", &P::stereo_consistency)
            .range(0.05, 10)
            .unit("px")
            .doc("Largest forward-backward error of a corner matched to the right image."),
        parameter<P, double>("nearest", &P::nearest)
            .range(0.01, 1000)
            .unit("m")
            .doc("Nearest depth that is searched for; sets the largest disparity."),
        parameter<P, double>("sigma_disparity", &P::sigma_disparity)
            .range(0.01, 10)
            .unit("px")
            .doc("Standard deviation of a far corner's disparity."),
        parameter<P, double>("sigma_doubling", &P::sigma_doubling)
            .range(0.1, 1e6)
            .unit("px")
            .doc("Disparity at which both variances are twice those of a far corner."),
        parameter<P, double>("offset_sigma", &P::offset_sigma)
            .range(0, 5)
            .unit("px")
            .doc("Standard deviation of an offset that all disparities share, which is estimated; "
                 "0: no "
                 "offset."));
  }

  static constexpr auto declaration() {
    using P = Parameters;
    return std::tuple_cat(cornerParameters<P>(), stereoParameters<P>(), poseParameters<P>());
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
        poseParameters<P>());
  }
};

}  // namespace tolman::feature_stereo
