// SPDX-License-Identifier: BSD-3-Clause
// Pixels of image messages as images of the SDK, and as depth.
#pragma once

#include <vector>

#include "coded_image.hpp"
#include "messages.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// Size of the image in a message of type `type`.
Result<ImageSize> imageSize(const std::string& type, Bytes message);

/// The image in a message of type `type`, as Gray8, or Bgr8 when `colour`. Of 16 bit the upper 8
/// are used. Failures have no place in them: the caller knows topic and time.
Result<Image> convertImage(const std::string& type, Bytes message, bool colour);

/// Depth in m row by row, 0 where it is not known, of a message of type Image with the encoding
/// 16UC1 (mm) or 32FC1 (m).
Result<std::vector<float>> convertDepth(Bytes message, ImageSize& size);

}  // namespace tolman::ros_bag
