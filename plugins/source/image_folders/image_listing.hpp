// SPDX-License-Identifier: BSD-3-Clause
// Lists the images of a folder in numerical order of their names, and checks that two folders
// match.
#pragma once

#include <filesystem>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

/// The PNG and JPEG files in `folder`, sorted by their names without extension: as decimal numbers
/// where areDecimals(), else by naturalLess(). It is an error if there are none, or two of the same
/// name. Two names that differ only in leading zeros are a warning, and so is the first gap in
/// numbers that are mostly evenly spaced.
std::vector<std::filesystem::path> listImages(const std::filesystem::path& folder,
                                              Inspection& inspection);

/// Adds an error for each image whose name (without extension) is not in the other list.
void checkPairs(const std::vector<std::filesystem::path>& left,
                const std::vector<std::filesystem::path>& right, Inspection& inspection);

}  // namespace tolman::image_folders
