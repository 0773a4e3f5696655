// SPDX-License-Identifier: BSD-3-Clause
// Files of images: which are there, in which order, and their bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "png_decoder.hpp"
#include "tolman/status.hpp"

namespace tolman::image_folders {

/// The PNG and JPEG files in `folder` but hidden ones, sorted by name. Throws DataError if there
/// are none.
std::vector<std::filesystem::path> findImages(const std::filesystem::path& folder);

/// The same in the order of the numbers in their names, which must be PREFIX NUMBER SUFFIX with one
/// prefix and one suffix; decimals, as of times, must be equally many. Throws DataError for other
/// names and for two of one number: their order would be a guess.
std::vector<std::filesystem::path> numberedImages(const std::filesystem::path& folder);

/// The images that `list` names, one a line: the first field of a line that is the name of an image
/// in `folder`, or of one relative to the list. Throws DataError.
std::vector<std::filesystem::path> listedImages(const std::filesystem::path& list,
                                                const std::filesystem::path& folder);

/// The bytes of an image. InvalidInput for a file that is missing or too large; Failed if it cannot
/// be read for other reasons (permissions, descriptors): it may be undamaged. Messages complete the
/// sentence "FILE ...".
Result<std::vector<std::uint8_t>> readBytes(const std::filesystem::path& file);

Result<coded_images::DepthValues> readDepthFile(const std::filesystem::path& file);

}  // namespace tolman::image_folders
