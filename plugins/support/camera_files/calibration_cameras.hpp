// SPDX-License-Identifier: BSD-3-Clause
// The cameras in a calibration file, whatever its format, and what they become together.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text_tree.hpp"
#include "tolman/camera.hpp"

namespace tolman::camera_files {

using Projection = Eigen::Matrix<double, 3, 4>;

struct FileCamera {
  RawCamera camera;  ///< width 0: the file does not say the size of the images
  int line = 0;
  bool has_pose = false;
  /// Rotation (in `camera`) and projection of the rectified camera, where the file has them.
  std::optional<Projection> P_rectified;
  int rectified_width = 0;  ///< px; 0: as the raw images, and only for pairs
  int rectified_height = 0;
};

struct FileCameras {
  std::vector<FileCamera> cameras;
  std::optional<Eigen::Isometry3d> T_second_first;  ///< OpenCV's R and T
};

/// Kalibr (camchain.yaml), ROS (camera_info), EuRoC (sensor.yaml), OpenCV (calibration and
/// stereo_calib). Throws FileError.
FileCameras camerasIn(const Node& tree);

/// calib_cam_to_cam.txt of KITTI's raw data: camera `left` and the one after it. Throws FileError.
FileCameras kittiRawCameras(std::string_view text, int left);

/// A rotation as files have it, of few digits, made orthonormal. Throws FileError.
Eigen::Matrix3d rotationOf(const Eigen::Matrix3d& M, int line);

}  // namespace tolman::camera_files
