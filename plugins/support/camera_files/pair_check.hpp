// SPDX-License-Identifier: BSD-3-Clause
// Calibrations of pairs say more than once where the second camera is.
#pragma once

#include "calibration_cameras.hpp"

namespace tolman::camera_files {

/// Compares the pose of the second camera that `cameras` has of this file with what other entries
/// say: T_cam_imu of Kalibr; R1, R2, P2 and Q of OpenCV. Throws FileError at a contradiction.
void checkPair(const Node& tree, const FileCameras& cameras);

}  // namespace tolman::camera_files
