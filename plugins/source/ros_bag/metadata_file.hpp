// SPDX-License-Identifier: BSD-3-Clause
// metadata.yaml of a ROS 2 bag: only the names of its files, in order. All else stands in these.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// The entries of `relative_file_paths` in the text of a metadata.yaml; none where there is no such
/// list.
std::vector<std::string> filesInMetadata(const std::string& text);

/// The files of the bag at `path`: itself, or those of a folder, by its metadata.yaml, or without
/// one all .mcap and .db3 files by name.
Result<std::vector<std::filesystem::path>> findBagFiles(const std::filesystem::path& path);

}  // namespace tolman::ros_bag
