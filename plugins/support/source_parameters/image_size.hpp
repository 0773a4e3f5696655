// SPDX-License-Identifier: BSD-3-Clause
// The size of images.
#pragma once

#include <string>

namespace tolman::source_parameters {

struct ImageSize {
  int width = 0;   ///< px
  int height = 0;  ///< px
  bool operator==(const ImageSize&) const = default;
  /// "640x480 px"
  std::string text() const { return std::to_string(width) + "x" + std::to_string(height) + " px"; }
};

}  // namespace tolman::source_parameters
