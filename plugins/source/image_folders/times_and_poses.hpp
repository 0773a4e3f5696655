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

/// Decimal exponent of the unit in nanoseconds: 9, 6, 3, 0.
constexpr int digitsOf(TimeUnit unit) { return 9 - 3 * static_cast<int>(unit); }

/// Stamps in ns; they must increase strictly. `column` is a name in the first line of the table, or
/// empty for a file with one number per line. A line with an error gives an error in `inspection`
/// and still counts as an entry. A median step that suggests another unit is an error (over 10 s)
/// or a warning (over 5 s, below 0.1 ms).
std::vector<std::int64_t> readTimes(const std::filesystem::path& file, const std::string& column,
                                    Inspection& inspection, TimeUnit unit = TimeUnit::Seconds);

/// Of at least two times, ns. Half of the steps are shorter.
std::int64_t medianStep(std::span<const std::int64_t> times);

/// Sorts the files by the times that are their names (a number with sign, decimals and exponent),
/// and returns these in ns. A name that is no time and two equal times are errors, and the median
/// step is checked as by readTimes().
std::vector<std::int64_t> sortByTimes(std::vector<std::filesystem::path>& files, TimeUnit unit,
                                      Inspection& inspection);

/// KITTI's poses: T_world_camera0 as 12 numbers per line, row by row, m. The number of the line of
/// each is added to `lines`.
std::vector<Eigen::Isometry3d> readKittiPoses(const std::filesystem::path& file,
                                              Inspection& inspection,
                                              std::vector<int>* lines = nullptr);

/// Adds an error unless `file` has as many entries as there are images. No error for no entries:
/// there is one already.
void checkCount(const std::filesystem::path& file, std::size_t entries, std::size_t images,
                Inspection& inspection);

}  // namespace tolman::image_folders
