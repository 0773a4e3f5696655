// SPDX-License-Identifier: BSD-3-Clause
// Interpolation and box means, against sums over every pixel.
#include "image_samples.hpp"

#include <catch2/catch.hpp>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

TEST_CASE("bilinear interpolation is exact on planes, and constant outside") {
  std::vector<float> plane;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      plane.push_back(static_cast<float>(2 * column - 3 * row));
    }
  }
  const ImageSamples samples{plane, 7, 5};
  CHECK(samples.at(2.25F, 1.5F) == Approx(0.0F));
  CHECK(samples.at(6, 4) == Approx(0.0F));
  CHECK(samples.at(-5, 0) == Approx(0.0F));
  CHECK(samples.at(90, -1) == Approx(12.0F));
}

TEST_CASE("box means are those of the pixels in the box, less at the border") {
  RandomStream random(5);
  constexpr int kWidth = 37;  // whole groups of lines and single ones
  constexpr int kHeight = 11;
  std::vector<float> image;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    image.push_back(static_cast<float>(random.uniform(0, 10)));
  }
  for (const int radius : {1, 3, 20}) {
    const std::vector<float> blurred = boxBlur(image, kWidth, kHeight, radius);
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        double sum = 0;
        int count = 0;
        for (int r = std::max(row - radius, 0); r <= std::min(row + radius, kHeight - 1); ++r) {
          for (int c = std::max(column - radius, 0); c <= std::min(column + radius, kWidth - 1);
               ++c) {
            sum += static_cast<double>(image[static_cast<std::size_t>(r * kWidth + c)]);
            ++count;
          }
        }
        CAPTURE(radius, row, column);
        REQUIRE(static_cast<double>(blurred[static_cast<std::size_t>(row * kWidth + column)]) ==
                Approx(sum / count).epsilon(1e-5));
      }
    }
  }
}
