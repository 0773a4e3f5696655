// SPDX-License-Identifier: BSD-3-Clause
// Several series of images in one folder, such as cam0_17 and cam1_17 of two cameras.
#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace tolman::image_folders {

/// Two images of the same number whose names differ otherwise, if the folder consists of two to
/// eight series of names and most numbers of each are those of another one as well.
std::optional<std::pair<std::filesystem::path, std::filesystem::path>> twoOfOneNumber(
    const std::vector<std::filesystem::path>& images);

}  // namespace tolman::image_folders
