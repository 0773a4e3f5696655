// SPDX-License-Identifier: BSD-3-Clause
// A rendered street for tests: ground, two walls and an end, all with a smooth random texture.
#pragma once

#include "tolman/camera.hpp"
#include "tolman/records.hpp"

namespace tolman::test {

/// 480 x 200 px, f = 300 px, baseline 0.5 m.
CameraRig streetRig();

/// What the rig sees at this pose; frame and stamp (10 Hz) are set from `index`.
Frame streetFrame(std::int64_t index, const Eigen::Isometry3d& T_world_camera);

/// The depth image of the left camera at this pose, m; 0 where nothing is in view.
NamedArray streetDepth(const Eigen::Isometry3d& T_world_camera);

/// The frame, as the one of another index at 10 Hz.
Frame again(const Frame& frame, std::int64_t index);

/// The frame with new noise (1.5 grey levels) and three people who walk past, 3 to 5 m away.
Frame withPassersBy(const Frame& frame, std::int64_t index);

/// An image of one grey level, of the street's size.
Image filled(int grey);

/// Each grey level changed to gain * level + offset, cut off at 0 and 255.
Image changed(const Image& image, double gain, double offset);

}  // namespace tolman::test
