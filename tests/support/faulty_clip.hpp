// SPDX-License-Identifier: BSD-3-Clause
// Copies of a stereo clip in KITTI's layout whose cameras have faults.
#pragma once

#include <filesystem>
#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace tolman::test {

/// The images of a clip, all grey.
struct StereoClip {
  std::vector<cv::Mat> left;
  std::vector<cv::Mat> right;
};

/// The first `frames` frames of the clip in `folder`.
StereoClip readClip(const std::filesystem::path& folder, int frames);

/// Writes the images with calibration, times and poses of the clip in `original`.
void writeClip(const StereoClip& clip, const std::filesystem::path& original,
               const std::filesystem::path& folder);

/// A fault of the cameras, and what it does to a clip whose frames `first` ... `last` it affects.
struct CameraFault {
  std::string name;
  std::function<void(StereoClip&, int first, int last)> apply;
};
std::vector<CameraFault> cameraFaults();

}  // namespace tolman::test
