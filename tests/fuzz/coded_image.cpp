// SPDX-License-Identifier: BSD-3-Clause
// The input as a PNG or JPEG image, in grey and colour.
#include "coded_image.hpp"

#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const int orientation = coded_images::orientationOf({data, size});
  fuzz::require(orientation >= 1 && orientation <= 8, "an orientation that is none");
  for (const bool colour : {false, true}) {
    source_parameters::UsedBits bits;
    const auto image = coded_images::decodeImage({data, size}, colour, bits);
    if (!image.isOk()) continue;
    fuzz::require(image.value().format() == (colour ? PixelFormat::Bgr8 : PixelFormat::Gray8),
                  "an image of another format than was asked for");
    unsigned sum = 0;  // every pixel is there
    const int row = image.value().width() * bytesPerPixel(image.value().format());
    for (int y = 0; y < image.value().height(); ++y) {
      for (int x = 0; x < row; ++x) sum += image.value().row(y)[x];
    }
    fuzz::require(sum <= 255U * static_cast<unsigned>(row * image.value().height()), "impossible");
  }
  return 0;
}
