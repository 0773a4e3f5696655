// SPDX-License-Identifier: BSD-3-Clause
// The mirrored drive has the same templates, and turns of the opposite sign. The storage format of
// pixels has no effect.
#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

constexpr int kViewWidth = 160;
constexpr int kViewHeight = 64;

/// The whole image, in cells of whole pixels, so that none is left over at one side.
ParameterValues whole() {
  return {{"crop", std::vector<double>{0, 1, 0, 1}},
          {"columns", std::int64_t{40}},
          {"rows", std::int64_t{8}}};
}

Image mirrored(const Image& image) {
  return gray(image.width(), image.height(),
              [&](int x, int y) { return image.row(y)[image.width() - 1 - x]; });
}

/// Views of a panorama at random headings: many of them near ones that came before.
std::vector<Image> drive(std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Image> images;
  for (int i = 0; i < 60; ++i) {
    const double heading = 0.8 * static_cast<double>(random.below(8)) + 0.03 * random.normal();
    images.push_back(pinholeView(kViewWidth, kViewHeight, 140, heading));
  }
  return images;
}

}  // namespace

TEST_CASE("a mirrored drive has the same templates and turns of the other sign") {
  for (const char* cells : {"grey", "gradients"}) {
    ParameterValues values = whole();
    values["cells"] = std::string(cells);
    values["threshold"] = 0.06;
    // Eight samples of whole pixels to a cell.
    if (std::string(cells) == "gradients") values["columns"] = std::int64_t{20};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      ViewTemplates plain;
      ViewTemplates reflected;
      REQUIRE(configure(plain, values).isOk());
      REQUIRE(configure(reflected, values).isOk());
      int familiar = 0;
      int turned = 0;
      std::int64_t frame = 0;
      for (const Image& image : drive(seed)) {
        const PlaceObservation a = observe(plain, image, frame);
        const PlaceObservation b = observe(reflected, mirrored(image), frame++);
        CAPTURE(cells, seed, frame);
        REQUIRE(a.recognition == b.recognition);
        REQUIRE(a.template_id == b.template_id);
        REQUIRE(a.relative_yaw == Approx(-b.relative_yaw).margin(1e-4));
        familiar += a.recognition == Recognition::Familiar;
        turned += std::abs(a.relative_yaw) > 1e-3;
      }
      CHECK(familiar > 20);
      CHECK(turned > 5);
    }
  }
}

TEST_CASE("rows with padding behind them are the same image") {
  ViewTemplates packed;
  ViewTemplates padded;
  REQUIRE(configure(packed, whole()).isOk());
  REQUIRE(configure(padded, whole()).isOk());
  constexpr std::ptrdiff_t kStride = kViewWidth + 13;
  std::int64_t frame = 0;
  for (const Image& image : drive(9)) {
    const auto bytes = std::make_shared<std::vector<std::uint8_t>>(kStride * kViewHeight, 99);
    for (int y = 0; y < kViewHeight; ++y) {
      std::copy_n(image.row(y), kViewWidth, bytes->begin() + y * kStride);
    }
    const Image other(bytes->data(), kViewWidth, kViewHeight, kStride, PixelFormat::Gray8, bytes);
    const PlaceObservation a = observe(packed, image, frame);
    const PlaceObservation b = observe(padded, other, frame++);
    REQUIRE(a.template_id == b.template_id);
    REQUIRE(a.recognition == b.recognition);
    REQUIRE(a.relative_yaw == b.relative_yaw);
  }
}
