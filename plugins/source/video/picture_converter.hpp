// SPDX-License-Identifier: BSD-3-Clause
// Decoded pictures of any pixel format as grey or colour images.
#pragma once

#include <memory>

#include "capture.hpp"

struct AVFrame;
struct SwsContext;

namespace tolman::video {

/// Converts to Gray8 (luminance, black 0 and white 255) or Bgr8, and turns the picture clockwise.
class PictureConverter {
 public:
  /// `quarter_turns`: 0 to 3, the display rotation that the file gives.
  PictureConverter(bool colour, int quarter_turns);
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
