// SPDX-License-Identifier: BSD-3-Clause
// Reads timestamps.txt of KITTI's raw data: one "2011-09-26 13:02:25.964389445" per line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

/// Nanoseconds since 1970, as if the dates were UTC; they must increase strictly. A line with an
/// error gives an error in `inspection` and still counts as an entry.
std::vector<std::int64_t> readDates(const std::filesystem::path& file, Inspection& inspection);

}  // namespace tolman::image_folders
