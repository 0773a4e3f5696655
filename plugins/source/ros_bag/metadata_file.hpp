// SPDX-License-Identifier: BSD-3-Clause
// The names of the files in metadata.yaml of a ROS 2 bag, in order. All other data are in the
// files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// The entries of `relative_file_paths` in the text of a metadata.yaml; empty without such a list.
std::vector<std::string> filesInMetadata(const std::string& text);

/// The files of the bag at `path`: the file itself, or those in a folder, in the order of its
/// metadata.yaml. Without one: all .mcap, .db3 and .bag files by name.
Result<std::vector<std::filesystem::path>> findBagFiles(const std::filesystem::path& path);

}  // namespace tolman::ros_bag
