// SPDX-License-Identifier: BSD-3-Clause
// Invalid images of a source.
#include <catch2/catch.hpp>
#include <vector>

#include "host/values.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

CameraRig stereo() {
  CameraRig rig;
  rig.width = 4;
  rig.height = 2;
  rig.baseline = 0.5;
  return rig;
}

Image gray(int width = 4, int height = 2) {
  return Image::create(width, height, PixelFormat::Gray8, [](std::uint8_t*) {});
}

std::string refusal(Image left, Image right, const CameraRig& rig = stereo()) {
  Frame frame;
  frame.left = std::move(left);
  frame.right = std::move(right);
  return checkImages(frame, rig).message();
}

}  // namespace

TEST_CASE("a whole pair, no images, and a single camera are sound") {
  CHECK(refusal(gray(), gray()).empty());
  CHECK(refusal({}, {}).empty());
  CameraRig single = stereo();
  single.baseline = 0;
  CHECK(refusal(gray(), {}, single).empty());
}

TEST_CASE("half a pair, or two formats, are refused") {
  CHECK(refusal(gray(), {}) ==
        "only the left image of a pair; give both, or none and a 'defect' that says why");
  CHECK(refusal({}, gray()).starts_with("only the right image of a pair"));
  const Image colour = Image::create(4, 2, PixelFormat::Bgr8, [](std::uint8_t*) {});
  CHECK(refusal(colour, gray()) == "the images of a pair have different pixel formats");
  CHECK(refusal(colour, colour).empty());
}

TEST_CASE("pixels that are not there are not read") {
  CHECK(refusal({nullptr, 4, 2, 4, PixelFormat::Gray8, nullptr}, gray()) ==
        "the left image has 4x2 px and no data");
  const std::vector<std::uint8_t> pixels(24);
  CHECK(refusal(gray(), {pixels.data(), 4, 2, 3, PixelFormat::Gray8, nullptr}) ==
        "the right image has rows of 4 bytes and a stride of 3");
  CHECK(refusal({pixels.data(), 4, 2, -4, PixelFormat::Gray8, nullptr}, gray()) ==
        "the left image has rows of 4 bytes and a stride of -4");
  CHECK(refusal({pixels.data(), 4, 2, 4, PixelFormat::Bgr8, nullptr}, gray()) ==
        "the left image has rows of 12 bytes and a stride of 4");
  CHECK(refusal({pixels.data(), 4, 2, 12, static_cast<PixelFormat>(9), nullptr}, gray()) ==
        "the left image has an unknown pixel format");
  CHECK(refusal(gray(3, 2), gray()) == "an image of 3x2 px; the rig has 4x2");
}
