// SPDX-License-Identifier: BSD-3-Clause
// The row search: sub-pixel bias, large disparities, brightness, and matches to refuse.
#include "static_stereo.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "street.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

/// A smooth random pattern: waves of many lengths, none shorter than 7 px, so that shifting it is
/// exact.
class Waves {
 public:
  explicit Waves(std::uint64_t seed) {
    RandomStream random(seed);
    for (Wave& wave : waves_) {
      wave = {random.uniform(0.02, 0.9), random.uniform(-0.7, 0.7), random.uniform(0, 6.28)};
    }
  }
  double at(double u, double v) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::sin(wave.fu * u + wave.fv * v + wave.phase);
    return 125 + 8 * sum;
  }

 private:
  struct Wave {
    double fu, fv, phase;
  };
  Wave waves_[40];
};

GrayLevel shifted(const Waves& waves, double disparity, double gain = 1, double offset = 0) {
  return test::levelOf(400, 60, [&](int u, int v) {
    return std::lround(std::clamp(gain * waves.at(u + disparity, v) + offset, 0.0, 255.0));
  });
}

}  // namespace

TEST_CASE("disparities are unbiased at every fraction of a pixel") {
  const Waves waves(5);
  const GrayLevel left = shifted(waves, 0);
  for (double disparity = 20; disparity < 21.01; disparity += 0.1) {
    const GrayLevel right = shifted(waves, disparity);
    double sum = 0;
    int found = 0;
    int wrong = 0;
    for (int u = 60; u < 390; u += 3) {
      for (int v = 8; v < 52; v += 11) {
        const auto match = matchStereo(left, right, u, v, {});
        if (!match) continue;
        ++found;
        const double error = match->disparity - disparity;
        wrong += std::abs(error) > 0.2 ? 1 : 0;
        sum += std::abs(error) > 0.2 ? 0 : error;
      }
    }
    CAPTURE(disparity, found);
    REQUIRE(found > 200);
    CHECK(100 * wrong < found);
    CHECK(std::abs(sum / found) < 0.01);
  }
}

TEST_CASE("disparities from behind infinity to far beyond 128 px are found") {
  const Waves waves(8);
  const GrayLevel left = shifted(waves, 0);
  for (const double disparity : {-0.4, 0.0, 1.3, 45.0, 127.6, 158.2}) {
    const GrayLevel right = shifted(waves, disparity);
    int found = 0;
    for (int u = 180; u < 390; u += 7) {
      const auto match = matchStereo(left, right, u, 30, {});
      if (!match) continue;
      ++found;
      CHECK(match->disparity == Approx(disparity).margin(0.15));
      CHECK(match->sigma > 0);
      CHECK(match->sigma < 0.5);
    }
    CAPTURE(disparity);
    CHECK(found > 15);
  }
}

TEST_CASE("two cameras may differ in brightness") {
  const Waves waves(13);
  const GrayLevel left = shifted(waves, 0);
  const GrayLevel right = shifted(waves, 30, 0.8, 12);
  StereoSearch search;
  balanceBrightness(left, right, search);
  CHECK(search.gain == Approx(0.8).margin(0.02));
  CHECK(search.offset == Approx(12).margin(3));
  int found = 0;
  for (int u = 60; u < 390; u += 7) {
    const auto match = matchStereo(left, right, u, 30, search);
    if (!match) continue;
    ++found;
    CHECK(match->disparity == Approx(30).margin(0.15));
  }
  CHECK(found > 30);
}

TEST_CASE("repeated texture is refused as ambiguous") {
  const auto stripes = [](int u, int v) { return u / 4 % 4 == 0 ? 200 : 60 + v; };
  const GrayLevel image = test::levelOf(400, 60, stripes);
  for (int u = 200; u < 390; u += 5) CHECK_FALSE(matchStereo(image, image, u, 30, {}));
}

TEST_CASE("images that have nothing in common give hardly a match") {
  RandomStream random(21);
  const auto noise = [&random](int, int) { return random.below(256); };
  const GrayLevel left = test::levelOf(400, 60, noise);
  const GrayLevel right = test::levelOf(400, 60, noise);
  int found = 0;
  for (int u = 170; u < 390; ++u) found += matchStereo(left, right, u, 30, {}) ? 1 : 0;
  CHECK(found < 10);
}

TEST_CASE("edges along the row say nothing about the disparity") {
  const GrayLevel image = test::levelOf(400, 60, [](int, int v) { return v < 30 ? 50 : 200; });
  for (int u = 20; u < 380; u += 20) CHECK_FALSE(matchStereo(image, image, u, 30, {}));
}

TEST_CASE("the street's walls and ground have their depth") {
  const CameraRig rig = test::streetRig();
  const auto window = test::streetWindow({test::streetPose(0)});
  const Keyframe& keyframe = window->newest();
  int found = 0;
  int wrong = 0;
  for (int v = 20; v < 190; v += 9) {
    for (int u = 120; u < 470; u += 11) {
      const auto match = matchStereo(keyframe.left.level(0), keyframe.right.level(0), u, v, {});
      if (!match) continue;
      ++found;
      const double truth =
          rig.pinhole.fx * rig.baseline * test::streetInverseDepth(test::streetPose(0), u, v);
      wrong += std::abs(match->disparity - truth) > 0.5 ? 1 : 0;
    }
  }
  CHECK(found > 100);
  CHECK(20 * wrong < found);
}
