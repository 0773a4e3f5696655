// SPDX-License-Identifier: BSD-3-Clause
// Images and depth maps as PNG bytes, fast rather than small.
#pragma once

#include <string>

#include "tolman/fields.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::dataset {

/// 8 bits a channel; the image must not be empty.
Result<std::string> encodePng(const Image& image);

/// 16 bits, metres * 256, as in KITTI's depth maps. 0 means no depth: also for values below half a
/// step or above the range of 16 bits (256 m). `depth` is in metres; InvalidInput if its shape is
/// not {height, width}.
Result<std::string> encodeDepthPng(const NamedArray& depth);

}  // namespace tolman::dataset
