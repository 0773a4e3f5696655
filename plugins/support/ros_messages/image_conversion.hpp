// SPDX-License-Identifier: BSD-3-Clause
// Pixels of image messages as images of the SDK, and as depth.
#pragma once

#include <vector>

#include "image_size.hpp"
#include "messages.hpp"
#include "tolman/fields.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"
#include "used_bits.hpp"

namespace tolman::ros_messages {

using source_parameters::ImageSize;
using source_parameters::UsedBits;

/// Size of the image in a message of type `type`.
Result<ImageSize> imageSize(const std::string& type, const Message& message);

/// Whether the rows of an uncompressed image are a multiple of what encoding and width need, as
/// with colour images that are labelled grey. Padding is shorter, but a view of a part of a larger
/// image may have such rows, so this is a doubt, no failure. Without topic; empty if there is none.
std::string doubtOfRows(const Message& message);

/// The image in a message of type `type`, as Gray8, or as Bgr8 if `colour`. Values of 16
/// bits are converted by `bits`. Failures do not name topic and time; the caller adds them.
Result<Image> convertImage(const std::string& type, const Message& message, bool colour,
                           UsedBits& bits);
/// The same with the upper 8 of 16 bits.
Result<Image> convertImage(const std::string& type, const Message& message, bool colour);

/// The same for images of one size, that of the first image of the topic `first`.
Result<Image> convertImage(const std::string& type, const Message& message, bool colour,
                           ImageSize size, const std::string& first, UsedBits& bits);

/// Whether the image in a message of type `type` is one of depth, by its encoding.
bool isDepth(const std::string& type, const Message& message);

/// Depth in m, row by row, 0 where unknown, of an Image with the encoding 16UC1 (mm) or 32FC1 (m),
/// or of a CompressedImage as image_transport writes it: PNG of 16UC1, or `compressedDepth`.
Result<std::vector<float>> convertDepth(const std::string& type, const Message& message,
                                        ImageSize& size);

/// Description of the sensor array `depth`.
ArrayInfo depthInfo();

}  // namespace tolman::ros_messages
