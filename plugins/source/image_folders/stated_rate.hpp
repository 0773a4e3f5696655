// SPDX-License-Identifier: BSD-3-Clause
// The rate that sensor.yaml of EuRoC states, against the times of the images.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

/// Warns if `rate_hz` of the file differs by a factor from the median rate of the images. A file
/// that is missing or states no rate is none to compare.
void checkStatedRate(const std::filesystem::path& file, const std::vector<std::int64_t>& stamps_ns,
                     Inspection& inspection);

}  // namespace tolman::image_folders
