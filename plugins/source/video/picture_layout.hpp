// SPDX-License-Identifier: BSD-3-Clause
// Two cameras in one picture: its halves.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "capture.hpp"

namespace tolman::video {

enum class PictureLayout : std::uint8_t {
  Mono,        ///< one camera
  SideBySide,  ///< left camera in the left half, right camera in the right half
  TopBottom,   ///< left camera in the upper half, right camera in the lower half
};
inline constexpr std::array<std::string_view, 3> kPictureLayoutNames = {"mono", "side_by_side",
                                                                        "top_bottom"};
constexpr std::span<const std::string_view> enumNames(PictureLayout) { return kPictureLayoutNames; }

/// Size of one camera's image. InvalidParameter for a picture that cannot be halved.
Result<PictureSize> cameraSize(PictureSize picture, PictureLayout layout);

/// The image of the left (or only) camera, a view of the same pixels.
Image leftImage(const Image& picture, PictureLayout layout);
/// The image of the right camera; empty for one camera.
Image rightImage(const Image& picture, PictureLayout layout);

}  // namespace tolman::video
