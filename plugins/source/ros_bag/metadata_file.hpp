// SPDX-License-Identifier: BSD-3-Clause
// The files of a bag, and what the metadata.yaml of a ROS 2 bag says of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "metadata_text.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// Of the bag in the folder `path`; empty of a file, and without a metadata.yaml.
BagMetadata metadataOf(const std::filesystem::path& path);

/// A problem if fewer messages were found in the bag at `path` than its metadata.yaml says; else
/// empty.
std::string missingMessages(const std::filesystem::path& path, const BagMetadata& metadata,
                            std::int64_t messages);

/// A warning for each bag in the folder that its metadata.yaml does not name, or, without one, for
/// numbers that are missing in the names. `used`: the files that were read.
std::vector<std::string> oddFiles(const std::filesystem::path& path, const BagMetadata& metadata,
                                  const std::vector<std::filesystem::path>& used);

/// The files of the bag at `path`: the file itself, or those in a folder, in the order of its
/// metadata.yaml. Without one: all .mcap, .db3 and .bag files by name.
Result<std::vector<std::filesystem::path>> findBagFiles(const std::filesystem::path& path);

}  // namespace tolman::ros_bag
