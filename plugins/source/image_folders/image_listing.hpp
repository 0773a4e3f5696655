// SPDX-License-Identifier: BSD-3-Clause
// Lists the images of a folder in the order of their names, and the images of a second camera.
#pragma once

#include <filesystem>
#include <vector>

#include "inspection.hpp"

namespace tolman::image_folders {

/// Whether the name is that of a PNG or JPEG file.
bool isImage(const std::filesystem::path& file);

/// The PNG and JPEG files in `folder`, in any order. It is an error if there are none, or two of
/// the same name without extension. Hidden images (".cover.png") are left out with one warning,
/// unless their name is a number (".5.png"); macOS's "._NAME.png" without one.
std::vector<std::filesystem::path> findImages(const std::filesystem::path& folder,
                                              Inspection& inspection);

/// The same in the order of orderNames(). Names whose order is in doubt are a warning, otherwise
/// two names of the same number are, and the first gap in numbers that are mostly evenly spaced.
std::vector<std::filesystem::path> listImages(const std::filesystem::path& folder,
                                              Inspection& inspection);

/// The images in `folder` in the order of those in `left` with the same names (without extension).
/// An image without such a partner is an error, on either side.
std::vector<std::filesystem::path> listPartners(const std::vector<std::filesystem::path>& left,
                                                const std::filesystem::path& folder,
                                                Inspection& inspection);

}  // namespace tolman::image_folders
