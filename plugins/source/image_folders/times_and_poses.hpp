// SPDX-License-Identifier: BSD-3-Clause
// Reads stamps (times.txt or a column of a table; ns) and true poses (poses.txt; m), one line per
// frame.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

enum class TimeUnit : std::uint8_t { Seconds, Milliseconds, Microseconds, Nanoseconds };
inline constexpr std::array<std::string_view, 4> kTimeUnitNames = {"s", "ms", "us", "ns"};
constexpr std::span<const std::string_view> enumNames(TimeUnit) { return kTimeUnitNames; }

/// Digits of nanoseconds in one of the unit: 9, 6, 3, 0.
constexpr int digitsOf(TimeUnit unit) { return 9 - 3 * static_cast<int>(unit); }

/// Stamps in ns; they must increase strictly. `column` is a name of the table's first
/// line, or empty for a file of one number a line. A line
/// with an error is an error in `inspection`, and still counts as an entry. Steps that only other
/// units explain are an error (over 1000 s) or a warning (over 5 s).
std::vector<std::int64_t> readTimes(const std::filesystem::path& file, const std::string& column,
                                    Inspection& inspection, TimeUnit unit = TimeUnit::Seconds);

/// Stamps from the names of files, with the same checks.
std::vector<std::int64_t> timesOfNames(const std::vector<std::filesystem::path>& files,
                                       TimeUnit unit, Inspection& inspection);

/// KITTI's poses: T_world_camera0 as 12 numbers a line, row by row.
std::vector<Eigen::Isometry3d> readKittiPoses(const std::filesystem::path& file,
                                              Inspection& inspection);

/// An error unless `file` has as many entries as there are images; no entries were explained.
void checkCount(const std::filesystem::path& file, std::size_t entries, std::size_t images,
                Inspection& inspection);

}  // namespace tolman::image_folders
