// SPDX-License-Identifier: BSD-3-Clause
#include "picture_layout.hpp"

#include <catch2/catch.hpp>

namespace tolman::video {
namespace {

/// A 6x4 picture whose bytes count upwards.
Image counting(PixelFormat format) {
  return Image::create(6, 4, format, [format](std::uint8_t* data) {
    for (int i = 0; i < 24 * bytesPerPixel(format); ++i) data[i] = static_cast<std::uint8_t>(i);
  });
}

}  // namespace

TEST_CASE("halves of a picture are views of its pixels") {
  const Image grey = counting(PixelFormat::Gray8);
  const Image left = leftImage(grey, PictureLayout::SideBySide);
  const Image right = rightImage(grey, PictureLayout::SideBySide);
  CHECK(left.width() == 3);
  CHECK(left.height() == 4);
  CHECK(left.data() == grey.data());
  CHECK(right.row(0)[0] == 3);
  CHECK(right.row(3)[2] == 23);
  const Image lower = rightImage(grey, PictureLayout::TopBottom);
  CHECK(lower.width() == 6);
  CHECK(lower.height() == 2);
  CHECK(lower.row(0)[0] == 12);
  const Image colour = rightImage(counting(PixelFormat::Bgr8), PictureLayout::SideBySide);
  CHECK(colour.row(1)[0] == 18 + 9);
  CHECK(colour.owner() != nullptr);
}

TEST_CASE("one camera has the whole picture") {
  const Image grey = counting(PixelFormat::Gray8);
  CHECK(leftImage(grey, PictureLayout::Mono).data() == grey.data());
  CHECK(rightImage(grey, PictureLayout::Mono).empty());
  CHECK(leftImage({}, PictureLayout::SideBySide).empty());
  CHECK(rightImage({}, PictureLayout::SideBySide).empty());
}

TEST_CASE("pictures without two equal halves are refused") {
  CHECK(cameraSize({6, 4}, PictureLayout::SideBySide).value() == PictureSize{3, 4});
  CHECK(cameraSize({6, 4}, PictureLayout::TopBottom).value() == PictureSize{6, 2});
  CHECK(cameraSize({7, 4}, PictureLayout::TopBottom).value() == PictureSize{7, 2});
  CHECK(cameraSize({7, 5}, PictureLayout::Mono).value() == PictureSize{7, 5});
  CHECK(cameraSize({7, 4}, PictureLayout::SideBySide).status().message() ==
        "pictures of 7x4 px are not two equal halves side by side; correct layout");
  CHECK_FALSE(cameraSize({6, 1}, PictureLayout::TopBottom).isOk());
}

}  // namespace tolman::video
