// SPDX-License-Identifier: BSD-3-Clause
// Masked rectangles get a smooth continuation of their surroundings; nothing else changes.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/camera_check.hpp"
#include "engine/pixel_map.hpp"

using namespace tolman;
using engine::ImageMask;

namespace {

constexpr int kWidth = 61;
constexpr int kHeight = 45;

CameraRig rig() {
  CameraRig rig;
  rig.width = kWidth;
  rig.height = kHeight;
  return rig;
}

/// Of the value value(x, y, channel).
template <class Value>
Image painted(PixelFormat format, Value&& value) {
  return Image::create(kWidth, kHeight, format, [&](std::uint8_t* out) {
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < bytesPerPixel(format); ++c) {
          *out++ = static_cast<std::uint8_t>(value(x, y, c));
        }
      }
    }
  });
}

bool isMasked(int x, int y) {
  return (x >= 10 && x < 30 && y >= 5 && y < 15) || y >= 36;  // a time, and a bonnet
}

}  // namespace

TEST_CASE("what is masked has no influence, and continues the rest smoothly") {
  const auto mask = ImageMask::create(rig(), {10, 5, 20, 10, 0, 36, kWidth, 9});
  REQUIRE(mask.isOk());
  for (const PixelFormat format : {PixelFormat::Gray8, PixelFormat::Bgr8}) {
    const auto scene = [](int x, int y, int c) { return 40 + 2 * x + y + 10 * c; };
    const Image image = painted(format, [&](int x, int y, int c) {
      return isMasked(x, y) ? (x * 37 + y * 91) % 256 : scene(x, y, c);
    });
    const Image filled = mask.value().apply(image);
    const int channels = bytesPerPixel(format);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        for (int c = 0; c < channels; ++c) {
          const int found = filled.row(y)[x * channels + c];
          CAPTURE(x, y, c);
          if (!isMasked(x, y)) REQUIRE(found == scene(x, y, c));
          if (isMasked(x, y) && y < 36) REQUIRE(std::abs(found - scene(x, y, c)) <= 14);
        }
      }
    }
  }
}

TEST_CASE("without a mask images are the same, and impossible masks are refused") {
  const auto none = ImageMask::create(rig(), {});
  REQUIRE(none.isOk());
  const Image image = painted(PixelFormat::Gray8, [](int x, int, int) { return x; });
  CHECK(none.value().apply(image).data() == image.data());
  CHECK_FALSE(ImageMask::create(rig(), {0, 0, 62, 10}).isOk());
  CHECK_FALSE(ImageMask::create(rig(), {0, 0, 10}).isOk());
  CHECK_FALSE(ImageMask::create(rig(), {0, 0, kWidth, kHeight}).isOk());
}

TEST_CASE("images whose projector blinks are noticed once, and those without its dots named") {
  const auto noticed = [](auto&& hasDots) {
    engine::Alternation alternation;
    std::vector<std::string> remedies;
    for (int i = 0; i < 40; ++i) {
      const Image image = painted(PixelFormat::Gray8, [&](int x, int y, int) {
        const int scene = 100 + (x * 7 + i) % 23 + (x * y + i * i) % 5;
        return hasDots(i) && (x * 31 + y * 17) % 19 == 0 ? 200 : scene;
      });
      if (const auto finding = alternation.add(image)) remedies.push_back(finding->remedy);
    }
    return remedies;
  };
  using Remedies = std::vector<std::string>;
  const std::string rest = " to source.first, and set source.step to 2";
  CHECK(noticed([](int i) { return i % 2 == 0; }) == Remedies{"use the others: add 1" + rest});
  CHECK(noticed([](int i) { return i % 2 == 1; }) == Remedies{"use the others: add 0" + rest});
  CHECK(noticed([](int) { return true; }).empty());
  CHECK(noticed([](int i) { return i % 3 == 0; }).empty());
}
