// SPDX-License-Identifier: BSD-3-Clause
// Writes a data set in the layout of the KITTI odometry benchmark.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "evaluation/loops.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"
#include "tolman/status.hpp"

namespace tolman::app {

/// 8 bits a channel; the image must not be empty.
Result<std::string> encodePng(const Image& image);

/// 16 bits, metres * 256, as in KITTI's depth maps. 0 means no depth: also for values below half a
/// step or above the range of 16 bits (256 m). `depth` is in metres; InvalidInput if its shape is
/// not {height, width}.
Result<std::string> encodeDepthPng(const NamedArray& depth);

/// Name of the array that a source describes as a depth image; empty when there is none.
std::string depthArray(const std::vector<ArrayInfo>& arrays);

/// P0 to P3; the right cameras have -fx * baseline.
std::string calibrationText(const CameraRig& rig);
/// Seconds, exact to the nanosecond, one line per image.
std::string timesText(const std::vector<std::int64_t>& stamps_ns);

/// InvalidInput if the frame has no sensor array `depth`; empty: none is needed.
Status requireDepth(const Frame& frame, const std::string& depth);

class KittiFolder {
 public:
  /// Creates the folder, or takes an empty one; with `replace` one that an earlier rendering has
  /// marked, whose image folders and text files are removed.
  static Result<KittiFolder> create(const std::filesystem::path& folder, bool replace);

  const std::filesystem::path& path() const { return folder_; }

  /// Grey images go to image_0 and image_1, colour ones to image_2 and image_3, as in KITTI, and
  /// the sensor array `depth` (empty: none) to depth_0. Each file is written atomically. Callable
  /// from any thread.
  Status writeFrame(std::int64_t index, const Frame& frame, const std::string& depth) const;

  /// Writes calib.txt (not for cameras without calibration), times.txt, and with a true pose for
  /// each image poses.txt and loops.txt. To be called last: a folder without times.txt is not a
  /// data set yet.
  Status writeTexts(const CameraRig& rig, const std::vector<std::int64_t>& stamps_ns,
                    const evaluation::Trajectory& truth,
                    const std::vector<evaluation::Revisit>& revisits) const;

 private:
  explicit KittiFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
  Status writeImage(const char* name, std::int64_t index, const Result<std::string>& png) const;

  std::filesystem::path folder_;
};

}  // namespace tolman::app
