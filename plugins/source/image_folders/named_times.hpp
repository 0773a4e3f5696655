// SPDX-License-Identifier: BSD-3-Clause
// Compares the times that a table gives to images with the names of these images: a table that was
// shifted, reversed or made from an unsorted list still has rising times.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "inspection.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {

/// Warns once of `table` where its rows, of which each has a time and an image, contradict the
/// names of the images:
/// - The names are times, in `unit` or another one, and one is more than half a frame away from the
///   time of its row. Numbers are times if they are ones since 1970 as the times of the table are,
///   or have decimals or 8 digits and cover the same span, at the same time.
/// - The names are numbers that fall while the times rise.
/// Names of counters that rise say nothing. The times must increase.
void checkNamedTimes(const std::filesystem::path& table,
                     const std::vector<std::filesystem::path>& images,
                     const std::vector<std::int64_t>& stamps_ns, TimeUnit unit,
                     Inspection& inspection);

/// Adds an error if a column of `table`, whose first line is a header, has the names of the files
/// in `images`, but in other rows: the times would go to other images than those that it names.
/// Says nothing unless there are as many rows as images. `root`: what the names may be relative to.
void checkNamedRows(const std::filesystem::path& table, const std::filesystem::path& root,
                    const std::vector<std::filesystem::path>& images, Inspection& inspection);

}  // namespace tolman::image_folders
