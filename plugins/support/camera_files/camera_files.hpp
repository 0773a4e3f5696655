// SPDX-License-Identifier: BSD-3-Clause
// Reads calibrations of raw cameras: Kalibr (camchain.yaml), OpenCV (cv::FileStorage as YAML or
// XML: a single camera, or stereo_calib's intrinsics and extrinsics), ROS (camera_info as YAML),
// EuRoC (sensor.yaml) and KITTI raw (calib_cam_to_cam.txt).
#pragma once

#include <filesystem>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::camera_files {

struct WantedCameras {
  int count = 1;  ///< 1, or 2 for a pair
  int width = 0;  ///< px, of the images; compared with the size in a file
  int height = 0;
  int kitti_left = 0;  ///< number of the left camera in KITTI's files: 0 or 2
};

/// The first cameras in the files: one file for all, or one for each. The rectified cameras are
/// taken from KITTI raw, or from ROS for a pair. A failure reads "FILE:LINE: what; remedy".
Result<RawRig> readCameras(const std::vector<std::filesystem::path>& files,
                           const WantedCameras& wanted);

/// Whether the file has one of these formats, and not that of KITTI's calib.txt (P0, P1).
bool isRawCalibration(const std::filesystem::path& file);

}  // namespace tolman::camera_files
