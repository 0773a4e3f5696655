// SPDX-License-Identifier: BSD-3-Clause
// Windows whose truth is known.
#pragma once

#include <algorithm>

#include "support/street_scene.hpp"
#include "tolman/context.hpp"
#include "window.hpp"

namespace tolman::feature_stereo {

inline Eigen::Isometry3d truePose(int k) {
  return expSe3((Vector6d() << 0.05 * k, 0, 1.0 * k, 0, 0.02 * k, 0).finished());
}

/// Five keyframes that see 150 points, with disparities off by `offset` and this much noise.
inline Window makeWindow(double noise, double offset) {
  const CameraRig rig = test::streetRig();
  RandomStream random(11);
  Window window;
  for (int k = 0; k < 5; ++k) window.addKeyframe({10 * k, truePose(k)});
  for (int i = 0; i < 150; ++i) {
    Landmark landmark;
    landmark.point.coordinates << random.uniform(-0.6, 0.6), random.uniform(-0.3, 0.3),
        1 / random.uniform(7, 80);
    for (int k = 0; k < 5; ++k) {
      Observation seen{10 * k, *project(rig, truePose(k), landmark.point), i % 4 != 0};
      const Eigen::Vector3d unit(random.normal(), random.normal(), random.normal());
      seen.pixel += noise * unit + Eigen::Vector3d(0, 0, offset);
      landmark.observations.push_back(seen);
    }
    window.addLandmark(landmark);
  }
  return window;
}

/// Moves all but the first keyframe and all points a little.
inline void disturb(Window& window) {
  RandomStream random(12);
  for (std::size_t k = 1; k < window.keyframes().size(); ++k) {
    Vector6d twist;
    for (double& value : twist) value = 0.005 * random.normal();
    auto& T = window.keyframes()[k].T_world_camera;
    T = T * expSe3(twist);
  }
  for (auto& [id, landmark] : window.landmarks()) {
    landmark.point.coordinates.z() *= 1 + 0.02 * random.normal();
  }
}

inline double worstTranslation(const Window& window) {
  double worst = 0;
  for (const Keyframe& keyframe : window.keyframes()) {
    const Eigen::Isometry3d truth = truePose(static_cast<int>(keyframe.frame / 10));
    worst = std::max(worst, (truth.inverse() * keyframe.T_world_camera).translation().norm());
  }
  return worst;
}

}  // namespace tolman::feature_stereo
