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
  double offset_sigma = 0;
  double camera_height = 1.65;

  static constexpr auto declaration() {
    using P = Parameters;
    return tolman::parameters(
        parameter("points", &P::points)
            .range(100, 10000)
            .doc("How many points the window holds; accuracy against speed."),
        parameter("candidates", &P::candidates)
            .range(100, 20000)
            .doc("How many candidates are selected in a keyframe."),
        parameter("window", &P::window)
            .range(3, 7)
            .unit("keyframes")
            .doc("Keyframes that are adjusted together."),
        parameter("iterations", &P::iterations)
            .range(1, 50)
            .doc("Most Gauss-Newton steps of the window at a keyframe."),
        parameter("coupling", &P::coupling)
            .range(0, 10)
            .doc("Weight of static stereo in the window, the paper's lambda; 0 leaves the second "
                 "camera to the first guess of each depth."),
        parameter("keyframe_weight", &P::keyframe_weight)
            .range(0.1, 10)
            .doc("How readily keyframes are made; larger: more of them."),
        parameter("nearest", &P::nearest)
            .range(0.01, 1000)
            .unit("m")
            .doc("Nearest depth that is searched for; sets the largest disparity."),
        parameter("marginal_weight", &P::marginal_weight)
            .range(0, 1)
            .doc("Trust in what marginalised points and keyframes leave behind."),
        parameter("offset_sigma", &P::offset_sigma)
            .range(0, 5)
            .unit("px")
            .doc("How far all disparities may be off together; estimated; 0 trusts the source."),
        parameter("camera_height", &P::camera_height)
            .range(0.01, 100)
            .unit("m")
            .doc("Single camera: its assumed height above the ground, which sets the scale of the "
                 "first draft of the scene."));
  }
};

}  // namespace tolman::direct_sparse
