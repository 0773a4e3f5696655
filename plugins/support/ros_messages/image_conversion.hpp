// SPDX-License-Identifier: BSD-3-Clause
// Pixels of image messages as images of the SDK, and as depth.
#pragma once

#include <vector>

#include "coded_image.hpp"
#include "messages.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_messages {

/// Size of the image in a message of type `type`.
Result<ImageSize> imageSize(const std::string& type, const Message& message);

/// Whether the rows of an uncompressed image are a multiple of what encoding and width need, as
/// with colour images that are labelled grey. Padding is shorter, but a view of a part of a larger
/// image may have such rows, so this is a doubt, no failure. Without topic; empty if there is none.
std::string doubtOfRows(const Message& message);

/// The image in a message of type `type`, as Gray8, or as Bgr8 if `colour`. `deep`
/// says how 16 bits are used, and is filled in. Failures do not name topic and time; the caller
/// adds them.
Result<Image> convertImage(const std::string& type, const Message& message, bool colour,
                           DeepPixels& deep);
/// The same with the upper 8 of 16 bits.
Result<Image> convertImage(const std::string& type, const Message& message, bool colour);

/// The same for images of one size, that of the first image of the topic `first`.
Result<Image> convertImage(const std::string& type, const Message& message, bool colour,
                           ImageSize size, const std::string& first, DeepPixels& deep);

/// Depth in m, row by row, 0 where unknown. The message has the type Image and the encoding 16UC1
/// (mm) or 32FC1 (m).
Result<std::vector<float>> convertDepth(const Message& message, ImageSize& size);

}  // namespace tolman::ros_messages
