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

/// 16 bits, metres * 256, as KITTI's depth maps are. 0 stands for none, and for what is nearer than
/// half a step or farther than 16 bits can say (256 m). `depth` has the shape {height, width}, in
/// metres; InvalidInput when it has not.
Result<std::string> encodeDepthPng(const NamedArray& depth);

}  // namespace tolman::dataset
