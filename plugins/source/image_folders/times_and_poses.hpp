// SPDX-License-Identifier: BSD-3-Clause
// Reads times (ns) and true poses (m) of images. Functions throw DataError, which names file and
// line, unless they say otherwise.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/context.hpp"

namespace tolman::image_folders {

enum class TimeUnit : std::uint8_t { Seconds, Milliseconds, Microseconds, Nanoseconds };
inline constexpr std::array<std::string_view, 4> kTimeUnitNames = {"s", "ms", "us", "ns"};
constexpr std::span<const std::string_view> enumNames(TimeUnit) { return kTimeUnitNames; }

struct ImageTimes {
  std::vector<std::int64_t> stamps_ns;
  std::vector<float> exposure_ms;  ///< one for each image, or none
};

/// `column` is a name in the first line of a table; empty for a file with one time per line, or
/// with "NUMBER TIME EXPOSURE" per line, as TUM's monocular sets have it (exposure in ms).
ImageTimes readTimes(const std::filesystem::path& file, const std::string& column, TimeUnit unit);

/// timestamps.txt of KITTI's raw data, "2011-09-26 13:02:25.964389445" per line, as ns since 1970.
std::vector<std::int64_t> readDates(const std::filesystem::path& file);

/// Files with the time of each.
struct StampedFiles {
  std::vector<std::filesystem::path> files;
  std::vector<std::int64_t> stamps_ns;
};

/// A file of lines "TIME NAME"; the names are relative to `folder`. A line whose time is not later
/// than the one before becomes an error in `findings` and is left out.
StampedFiles readStampedFiles(const std::filesystem::path& file, TimeUnit unit,
                              const std::filesystem::path& folder, FindingCollector& findings);

/// Images whose names are their times, sorted by these.
StampedFiles sortedByTimes(std::vector<std::filesystem::path> images, TimeUnit unit);

/// KITTI's poses: T_world_camera0 as 12 numbers per line, row by row.
std::vector<Eigen::Isometry3d> readKittiPoses(const std::filesystem::path& file);

}  // namespace tolman::image_folders
