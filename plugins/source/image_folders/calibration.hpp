// SPDX-License-Identifier: BSD-3-Clause
// KITTI's calib.txt: projection matrices of rectified cameras, P = K [I | t].
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>

#include "inspection.hpp"
#include "tolman/camera.hpp"

namespace tolman::image_folders {

/// Calibration of one camera or one stereo pair.
struct Calibration {
  Pinhole pinhole;
  double baseline = 0;  ///< m; 0 for a single camera
  /// Origin of camera 0, whose poses KITTI gives, in the axes of the left camera, m.
  Eigen::Vector3d t_left_camera0 = Eigen::Vector3d::Zero();
};

/// Reads the matrices P<left> and, for a pair, P<left + 1>, and checks that they describe a
/// rectified rig as the SDK defines it, with the right camera to the right. Empty after an error.
std::optional<Calibration> readKittiCalibration(const std::filesystem::path& file, int left,
                                                bool stereo, Inspection& inspection);

}  // namespace tolman::image_folders
