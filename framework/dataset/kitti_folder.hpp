// SPDX-License-Identifier: BSD-3-Clause
// Writes a data set in the layout of the KITTI odometry benchmark.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/loop_truth.hpp"
#include "record/atomic_file.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::dataset {

/// What calib.txt, times.txt, poses.txt and loops.txt are made from; one entry an image.
struct DriveLog {
  std::vector<std::int64_t> stamps_ns;
  evaluation::Trajectory truth;  ///< frames as in the folder; as long as stamps_ns, or incomplete

  bool hasTruth() const { return !stamps_ns.empty() && truth.size() == stamps_ns.size(); }
};

/// P0 to P3; the right cameras have -fx * baseline.
std::string calibrationText(const CameraRig& rig);
/// Seconds, exact to the nanosecond, one line an image.
std::string timesText(const std::vector<std::int64_t>& stamps_ns);

/// Holds a lock on the folder while it lives, so that no two renderings write one.
class KittiFolder {
 public:
  /// Makes the folder. Fails when somebody else writes there, and when it is not empty, unless
  /// `replace`: then the files of an earlier rendering are removed, and nothing else.
  static Result<KittiFolder> create(const std::filesystem::path& folder, bool replace);

  const std::filesystem::path& path() const { return folder_; }

  /// Grey images go to image_0 and image_1, colour ones to image_2 and image_3, as in KITTI, and
  /// the sensor array `depth` (empty: none) to depth_0. Each file appears whole or not at all. Any
  /// thread.
  Status writeFrame(std::int64_t index, const Frame& frame, const std::string& depth) const;

  /// Writes calib.txt, times.txt, and with complete truth poses.txt and loops.txt. To be called
  /// last: a folder without times.txt is not a data set yet.
  Status writeTexts(const CameraRig& rig, const DriveLog& log,
                    const std::vector<Revisit>& revisits) const;

 private:
  KittiFolder(std::filesystem::path folder, record::FileDescriptor lock)
      : folder_(std::move(folder)), lock_(std::move(lock)) {}
  Status writeImage(const char* name, std::int64_t index, const Result<std::string>& png) const;

  std::filesystem::path folder_;
  record::FileDescriptor lock_;
};

}  // namespace tolman::dataset
