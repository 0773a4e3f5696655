// SPDX-License-Identifier: BSD-3-Clause
// Reads calibrations. Of raw cameras: Kalibr (camchain.yaml), OpenCV (cv::FileStorage as YAML or
// XML: a single camera, or stereo_calib's intrinsics and extrinsics), ROS (camera_info as YAML),
// EuRoC (sensor.yaml), KITTI raw (calib_cam_to_cam.txt), and TUM's monocular sets (camera.txt). Of
// rectified ones: KITTI's calib.txt.
#pragma once

#include <filesystem>
#include <vector>

#include "tolman/camera.hpp"

namespace tolman::camera_files {

struct WantedCameras {
  int count = 1;  ///< 1, or 2 for a pair
  int width = 0;  ///< px, of the images; compared with the size in a file. 0: of no images
  int height = 0;
  int kitti_left = 0;  ///< number of the left camera in KITTI's files: 0 or 2
};

/// The first cameras in the files: one file for all, or one for each. The rectified cameras are
/// taken from KITTI raw, or from ROS for a pair. Throws DataError.
RawRig readCameras(const std::vector<std::filesystem::path>& files, const WantedCameras& wanted);

struct RectifiedCameras {
  CameraRig rig;
  /// Origin of camera 0, whose poses KITTI gives, in the axes of the left camera, m.
  Eigen::Vector3d t_left_camera0 = Eigen::Vector3d::Zero();
};

/// The rig of KITTI's projection matrices P0, P1 ... (calib.txt). Throws DataError.
RectifiedCameras readRectified(const std::filesystem::path& file, const WantedCameras& wanted);

/// Whether the file has one of the formats of raw cameras.
bool isRawCalibration(const std::filesystem::path& file);

}  // namespace tolman::camera_files
