// SPDX-License-Identifier: BSD-3-Clause
// The cameras in a calibration file of any supported format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "projection.hpp"
#include "text_tree.hpp"
#include "tolman/camera.hpp"

namespace tolman::camera_files {

using source_parameters::Projection;

struct FileCamera {
  RawCamera camera;      ///< width 0: the file does not say the size of the images
  int line = 0;          ///< first line of the camera; 0: the whole file
  int size_line = 0;     ///< line of the size
  int pinhole_line = 0;  ///< line of focal lengths and principal point
  int rectified_line = 0;
  bool has_pose = false;
  /// Rotation (in `camera`) and projection of the rectified camera, where the file has them.
  std::optional<Projection> P_rectified;
  int rectified_width = 0;  ///< px; 0: that of the raw images, and used only for pairs
  int rectified_height = 0;
};

struct FileCameras {
  std::vector<FileCamera> cameras;
  std::optional<Eigen::Isometry3d> T_second_first;  ///< OpenCV's R and T
};

/// Kalibr (camchain.yaml), ROS (camera_info), EuRoC (sensor.yaml), OpenCV (calibration and
/// stereo_calib). Throws FileError.
FileCameras camerasIn(const Node& tree);

/// calib_cam_to_cam.txt of KITTI's raw data: camera `left` and the one after it, of which one or,
/// for a pair, two are wanted. Throws FileError, also for a pair whose entries contradict each
/// other.
FileCameras kittiRawCameras(std::string_view text, int left, int wanted);

/// The numbers of a list, or of a matrix with rows, cols and data. Throws FileError for another
/// count.
std::vector<double> numbersOf(const Node& node, std::size_t count);

/// Makes a rotation from a file, which has few digits, orthonormal. Throws FileError.
Eigen::Matrix3d rotationOf(const Eigen::Matrix3d& M, int line);

/// The numbers of the matrix `name`. Throws FileError unless it is fx 0 cx 0 fy cy 0 0 1.
Pinhole checkedPinhole(const Eigen::Matrix3d& K, int line, std::string_view name);

}  // namespace tolman::camera_files
