// SPDX-License-Identifier: BSD-3-Clause
// Disparities from a depth image: closed forms on planes, and depths that are no surface.
#include <catch2/catch.hpp>
#include <limits>

#include "stereo_matching.hpp"
#include "support/street_scene.hpp"

using namespace tolman;
using namespace tolman::feature_stereo;

namespace {

constexpr double kFxBaseline = 30;  // px m
constexpr int kDepthWidth = 40;
constexpr int kDepthHeight = 30;

/// depthAt(column, row) for each pixel.
template <class DepthAt>
NamedArray depthsOf(const DepthAt& depthAt) {
  NamedArray depth{"depth", {kDepthHeight, kDepthWidth}, {}};
  for (int row = 0; row < kDepthHeight; ++row) {
    for (int column = 0; column < kDepthWidth; ++column) {
      depth.values.push_back(static_cast<float>(depthAt(column, row)));
    }
  }
  return depth;
}

/// Depths of 3 m, with one value at column 10, row 20.
NamedArray flatBut(float value) {
  return depthsOf([&](int column, int row) { return column == 10 && row == 20 ? value : 3.0F; });
}

bool hasDisparity(const NamedArray& depth, float column, float row) {
  return !std::isnan(depthDisparities(depth, {{column, row}}, kFxBaseline)[0]);
}

/// A frame of the test camera with an image and this depth image.
Frame frameWith(const NamedArray& depth) {
  Frame frame;
  frame.left = test::filled(100);
  frame.sensors = {{"gyroscope", {1}, {0}}, depth};
  return frame;
}

}  // namespace

TEST_CASE("a plane has the disparities of its equation, between pixels too") {
  // The inverse depth of a plane is linear in the pixel.
  const auto inverse = [](double u, double v) { return 0.2 + 0.002 * u + 0.0015 * v; };
  const NamedArray depth = depthsOf([&](int u, int v) { return 1 / inverse(u, v); });
  for (const auto& [u, v] : {std::pair(0.0, 0.0), std::pair(7.25, 12.5), std::pair(38.9, 28.9)}) {
    const float found =
        depthDisparities(depth, {{static_cast<float>(u), static_cast<float>(v)}}, kFxBaseline)[0];
    CHECK(found == Approx(kFxBaseline * inverse(u, v)).epsilon(1e-5));
  }
}

TEST_CASE("corners outside of the depth image and on its last row and column have no disparity") {
  const NamedArray depth = flatBut(3);
  CHECK(hasDisparity(depth, 38.5F, 28.5F));
  for (const auto& [u, v] : {std::pair(-0.5F, 5.0F), std::pair(5.0F, -0.5F), std::pair(39.0F, 5.0F),
                             std::pair(5.0F, 29.0F), std::pair(1e9F, 5.0F),
                             std::pair(std::numeric_limits<float>::quiet_NaN(), 5.0F)}) {
    CHECK_FALSE(hasDisparity(depth, u, v));
  }
}

TEST_CASE("beside a missing depth, or at an edge, there is no disparity") {
  for (const float missing : {0.0F, -1.0F, std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN(), 3.3F, 1e30F}) {
    CAPTURE(missing);
    const NamedArray depth = flatBut(missing);
    for (const auto& [u, v] : {std::pair(9.5F, 19.5F), std::pair(10.0F, 20.0F),
                               std::pair(10.9F, 20.9F), std::pair(9.1F, 20.0F)}) {
      CHECK_FALSE(hasDisparity(depth, u, v));
    }
    CHECK(hasDisparity(depth, 11.0F, 20.0F));
    CHECK(hasDisparity(depth, 8.9F, 20.0F));
  }
  CHECK(hasDisparity(flatBut(3.1F), 10.5F, 20.5F));  // a slope, as of a floor
}

TEST_CASE("a depth image is found by its names, the left camera's first") {
  NamedArray depth = flatBut(3);
  Frame frame = frameWith(depth);
  CHECK(depthImage(frame) == &frame.sensors[1]);
  depth.name = "depth.left";
  frame.sensors.push_back(depth);
  CHECK(depthImage(frame) == &frame.sensors[2]);
  frame.sensors.resize(1);
  CHECK(depthImage(frame) == nullptr);
}

TEST_CASE("frames without depth, or with depth of another size, are refused with the remedy") {
  CameraRig rig;
  rig.width = kDepthWidth;
  rig.height = kDepthHeight;
  Frame frame = frameWith(flatBut(3));
  CHECK(requireDepth(frame, rig).isOk());
  rig.width = 41;
  CHECK(requireDepth(frame, rig).code() == StatusCode::InvalidInput);
  CHECK(requireDepth(frame, rig).message() ==
        "the depth image has 40x30 values, the image 41x30 pixels; give depth images that are "
        "registered to the image");
  frame.sensors[1].shape = {kDepthWidth * kDepthHeight};
  CHECK_THAT(requireDepth(frame, rig).message(),
             Catch::Matchers::Contains("has 1 axes instead of row and column"));
  frame.sensors.clear();
  CHECK(requireDepth(frame, rig).code() == StatusCode::Unsupported);
  CHECK_THAT(requireDepth(frame, rig).message(),
             Catch::Matchers::Contains("the frame has no depth image; use a source"));
  frame.left = Image();
  CHECK(requireDepth(frame, rig).isOk());  // a damaged image
}
