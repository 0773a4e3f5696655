// SPDX-License-Identifier: BSD-3-Clause
// Decoded pictures of any pixel format as grey or colour images.
#pragma once

#include <memory>

#include "capture.hpp"
#include "value_widths.hpp"

struct AVFrame;
struct SwsContext;

namespace tolman::video {

/// Converts to Gray8 (luminance, black 0 and white 255) or Bgr8, and turns the picture clockwise.
class PictureConverter {
 public:
  /// `bits`: of grey pictures of 16 bits, the 8 highest of the lowest `bits` are taken, and larger
  /// values become 255. `quarter_turns`: 0 to 3, the display rotation that the file gives.
  PictureConverter(bool colour, int bits, int quarter_turns);
  ~PictureConverter();
  PictureConverter(const PictureConverter&) = delete;
  PictureConverter& operator=(const PictureConverter&) = delete;

  /// Counts the values of grey pictures of 16 bits in `widths`.
  Result<Image> convert(const AVFrame& picture, source_parameters::ValueWidths& widths);

 private:
  Image narrowed(const AVFrame& picture, source_parameters::ValueWidths& widths) const;

  bool colour_;
  int bits_;
  int quarter_turns_;
  SwsContext* scaler_ = nullptr;  ///< recreated by libswscale when size or format changes
};

}  // namespace tolman::video
