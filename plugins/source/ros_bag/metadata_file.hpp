// SPDX-License-Identifier: BSD-3-Clause
// metadata.yaml of a ROS 2 bag: the names of its files, in order, and the number of its messages.
// All other data are in the files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// The entries of `relative_file_paths` in the text of a metadata.yaml; empty without such a list.
std::vector<std::string> filesInMetadata(const std::string& text);

/// The number of messages of all topics in the text of a metadata.yaml.
std::optional<std::int64_t> messagesInMetadata(const std::string& text);

/// A problem if the bag in the folder `path` has fewer messages than its metadata.yaml says; else
/// empty.
std::string missingMessages(const std::filesystem::path& path, std::int64_t messages);

/// The files of the bag at `path`: the file itself, or those in a folder, in the order of its
/// metadata.yaml. Without one: all .mcap, .db3 and .bag files by name.
Result<std::vector<std::filesystem::path>> findBagFiles(const std::filesystem::path& path);

}  // namespace tolman::ros_bag
