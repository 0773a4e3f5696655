// SPDX-License-Identifier: BSD-3-Clause
// Decoded pictures of any pixel format as grey or colour images, and the two cameras in one
// picture.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "capture.hpp"

struct AVFrame;
struct SwsContext;

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

/// Converts to Gray8 (luminance, black 0 and white 255) or Bgr8, and turns the picture clockwise.
class PictureConverter {
 public:
  /// `quarter_turns`: 0 to 3, the display rotation that the file gives.
  PictureConverter(bool colour, int quarter_turns)
      : colour_(colour), quarter_turns_(quarter_turns) {}
  ~PictureConverter();
  PictureConverter(const PictureConverter&) = delete;
  PictureConverter& operator=(const PictureConverter&) = delete;

  Result<Image> convert(const AVFrame& picture);

 private:
  bool colour_;
  int quarter_turns_;
  SwsContext* scaler_ = nullptr;  ///< recreated by libswscale when size or format changes
};

}  // namespace tolman::video
