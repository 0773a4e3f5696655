// SPDX-License-Identifier: BSD-3-Clause
// Speeds of true poses, which `checks` does not see.
#pragma once

#include <filesystem>

#include "inspection.hpp"
#include "tum_poses.hpp"

namespace tolman::image_folders {

/// Warns of the first step between two poses that is faster than any vehicle, as poses that were
/// repeated and then jump have it, with its line. Poses without times are not checked.
void checkTrueSpeeds(const std::filesystem::path& file, const StampedPoses& truth,
                     Inspection& inspection);

}  // namespace tolman::image_folders
