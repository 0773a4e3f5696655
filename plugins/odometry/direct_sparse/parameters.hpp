// SPDX-License-Identifier: BSD-3-Clause
// Parameters of direct_sparse_stereo and direct_sparse_mono.
#pragma once

#include <tuple>

#include "tolman/parameters.hpp"

namespace tolman::direct_sparse {

/// Points, iterations and keyframe weight were chosen on KITTI 06 in both directions, such that
/// their cost is at most that of fewer keyframes with twice the points; the error on KITTI 01 was
/// known then. docs/report/odometry.md has the figures of other drives. The paper has 2000 points
/// and at most six iterations. Rectified rigs are off by up to 1 px of disparity. Parameters that
/// only one of the two plugins uses are declared by that one.
struct Parameters {
  int points = 1500;
  int window = 7;  // keyframes; 5 to 7 in DSO (Engel et al.)
  int iterations = 2;
  double coupling = 1.5;  // 1 to 2 is best in Stereo DSO (Wang et al. 2017)
  double keyframe_weight = 1.2;
  double largest_adjustment = 0.5;  // m; chosen, not tuned
  double offset_sigma = 1;          // px; as rigs are off (docs/report/odometry.md)
  double column_sigma = 0.3;        // px; chosen on the town, docs/report/odometry.md
  double calibration_distance = 4;  // m; boards at 2 to 6 m, where they fill a part of the image
  double row_sigma = 1;             // px; KITTI 06 and raw 0001 are off by 1.5 px in the corners
  double camera_height = 1.65;      // m; KITTI's car

  template <class P>
  static constexpr auto declare() {
    return tolman::parameters(
        parameter<P, int>("points", &P::points)
            .range(100, 10000)
            .doc("Number of points in the window: more are more accurate and slower."),
        parameter<P, int>("window", &P::window)
            .range(3, 7)
            .unit("keyframes")
            .doc("Keyframes that are adjusted together."),
        parameter<P, int>("iterations", &P::iterations)
            .range(1, 50)
            .doc("Maximum number of Gauss-Newton steps of the window at a keyframe."),
        parameter<P, double>("keyframe_weight", &P::keyframe_weight)
            .range(0.1, 10)
            .doc("Weight of image motion in the decision for a keyframe; larger: more keyframes."),
        parameter<P, double>("largest_adjustment", &P::largest_adjustment)
            .range(0, 1000)
            .unit("m")
            .doc("Largest plausible change of a keyframe's position when the window is adjusted; "
                 "beyond it the frame is lost and a new window is started."));
  }
  static constexpr auto declaration() {
    using P = Parameters;
    return std::tuple_cat(
        declare<P>(),
        tolman::parameters(
            parameter<P, double>("coupling", &P::coupling)
                .range(0, 10)
                .doc("Weight of static stereo in the window, the paper's lambda; 0 leaves the "
                     "second camera to the first estimate of each depth."),
            parameter<P, double>("offset_sigma", &P::offset_sigma)
                .range(0, 5)
                .unit("px")
                .doc("Standard deviation of an offset that all disparities share, which is "
                     "estimated; 0: no offset and no other errors of disparities."),
            parameter<P, double>("column_sigma", &P::column_sigma)
                .range(0, 5)
                .unit("px")
                .doc(
                    "Standard deviation of horizontal errors of the rectification, which are "
                    "estimated as a smooth field over the right image; for terms of degree n it is "
                    "divided by n + 1. The field is used where it exceeds 0.1 px. 0: only an "
                    "offset, as that of a turned camera."),
            parameter<P, double>("calibration_distance", &P::calibration_distance)
                .range(0, 1000)
                .unit("m")
                .doc("Distance at which the rig was calibrated: there its disparities are right "
                     "although they have an offset, as far as the field of horizontal errors shows "
                     "that it is not that of a camera which has turned since. 0: an offset is "
                     "that of a turned camera."),
            parameter<P, double>("row_sigma", &P::row_sigma)
                .range(0, 5)
                .unit("px")
                .doc("Standard deviation of vertical errors of the rectification, by which right "
                     "images are corrected; they are estimated as a smooth field over the image. "
                     "0: no correction.")));
  }
};

/// A single camera measures depth only by the motion between keyframes: keyframes are farther
/// apart, and there are more points and more iterations until depths converge. Chosen, not tuned.
struct MonoParameters : Parameters {
  constexpr MonoParameters() {
    points = 2000;
    iterations = 8;
    keyframe_weight = 0.6;
  }
  static constexpr auto declaration() {
    using P = MonoParameters;
    return std::tuple_cat(
        declare<P>(),
        tolman::parameters(
            parameter<P, double>("camera_height", &P::camera_height)
                .range(0.01, 100)
                .unit("m")
                .doc("Assumed height of the camera above the ground, which sets the scale of the "
                     "depths that are assumed at the start.")));
  }
};

}  // namespace tolman::direct_sparse
