// SPDX-License-Identifier: BSD-3-Clause
// Reads an input as an image file, in grey and colour, of the size in its header.
#pragma once

#include "image_file.hpp"
#include "input.hpp"

namespace tolman::fuzz {

inline void decode(Bytes bytes) {
  // Larger ones are allowed, and take as much time and memory as their size: nothing to find here.
  constexpr std::int64_t kMaxPixels = 1 << 20;
  const auto size = image_folders::checkImageBytes(bytes);
  if (!size.isOk() || std::int64_t{size.value().width} * size.value().height > kMaxPixels) return;
  const MemoryFile file(bytes);
  for (const bool colour : {false, true}) {
    const auto image = image_folders::readImageFile(file.path(), colour, size.value());
    if (!image.isOk()) continue;
    const image_folders::ImageSize decoded{image.value().width(), image.value().height()};
    require(decoded == size.value(), "an image of another size than its header says");
    require(image.value().format() == (colour ? PixelFormat::Bgr8 : PixelFormat::Gray8),
            "an image of another format than was asked for");
    unsigned sum = 0;  // every pixel is there
    const int row = image.value().width() * bytesPerPixel(image.value().format());
    for (int y = 0; y < image.value().height(); ++y) {
      for (int x = 0; x < row; ++x) sum += image.value().row(y)[x];
    }
    require(sum <= 255U * static_cast<unsigned>(row * image.value().height()), "impossible");
  }
}

}  // namespace tolman::fuzz
