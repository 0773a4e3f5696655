// SPDX-License-Identifier: BSD-3-Clause
// What a user can set about direct_sparse.
#pragma once

#include "tolman/parameters.hpp"

namespace tolman::direct_sparse {

struct Parameters {
  int points = 2000;
  int candidates = 1500;
  int window = 7;
  int iterations = 4;
  double coupling = 1.5;
  double keyframe_weight = 0.4;
  double nearest = 2.5;
  double marginal_weight = 0.06;
  double largest_adjustment = 0.5;
  double offset_sigma = 0;
  double camera_height = 1.65;

  template <class P>
  static constexpr auto declare() {
    return tolman::parameters(
        parameter<P, int>("points", &P::points)
            .range(100, 10000)
            .doc("How many points the window holds; accuracy against speed."),
        parameter<P, int>("candidates", &P::candidates)
            .range(100, 20000)
            .doc("How many candidates are selected in a keyframe."),
        parameter<P, int>("window", &P::window)
            .range(3, 7)
            .unit("keyframes")
            .doc("Keyframes that are adjusted together."),
        parameter<P, int>("iterations", &P::iterations)
            .range(1, 50)
            .doc("Most Gauss-Newton steps of the window at a keyframe."),
        parameter<P, double>("coupling", &P::coupling)
            .range(0, 10)
            .doc("Weight of static stereo in the window, the paper's lambda; 0 leaves the second "
                 "camera to the first guess of each depth."),
        parameter<P, double>("keyframe_weight", &P::keyframe_weight)
            .range(0.1, 10)
            .doc("How readily keyframes are made; larger: more of them."),
        parameter<P, double>("nearest", &P::nearest)
            .range(0.01, 1000)
            .unit("m")
            .doc("Nearest depth that is searched for; sets the largest disparity."),
        parameter<P, double>("marginal_weight", &P::marginal_weight)
            .range(0, 1)
            .doc("Trust in what marginalised points and keyframes leave behind."),
        parameter<P, double>("largest_adjustment", &P::largest_adjustment)
            .range(0, 1000)
            .unit("m")
            .doc("How far a keyframe may move when the window is adjusted; a window that moves one "
                 "farther is given up, the frame is lost."),
        parameter<P, double>("offset_sigma", &P::offset_sigma)
            .range(0, 5)
            .unit("px")
            .doc("How far all disparities may be off together; estimated; 0 trusts the source."),
        parameter<P, double>("camera_height", &P::camera_height)
            .range(0.01, 100)
            .unit("m")
            .doc("Single camera: its assumed height above the ground, which sets the scale of the "
                 "first draft of the scene."));
  }
  static constexpr auto declaration() { return declare<Parameters>(); }
};

/// A single camera sees depth only by the motion between keyframes: it wants more of them, and
/// depths that have converged.
struct MonoParameters : Parameters {
  constexpr MonoParameters() {
    iterations = 8;
    keyframe_weight = 0.6;
  }
  static constexpr auto declaration() { return declare<MonoParameters>(); }
};

}  // namespace tolman::direct_sparse
