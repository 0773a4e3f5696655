// SPDX-License-Identifier: BSD-3-Clause
// Weights of residuals, and the state of a keyframe.
#include <catch2/catch.hpp>
#include <set>

#include "gradient_samples.hpp"
#include "street.hpp"
#include "window.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

TEST_CASE("the pattern has eight different pixels around its centre, without a drift") {
  std::set<std::pair<int, int>> pixels;
  int sum_u = 0;
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    pixels.insert({kPatternU[k], kPatternV[k]});
    CHECK(std::abs(kPatternU[k]) + std::abs(kPatternV[k]) <= kPatternRadius);
    sum_u += kPatternU[k];
  }
  CHECK(pixels.size() == kPatternSize);
  CHECK(pixels.count({0, 0}) == 1);
  CHECK(std::abs(sum_u) <= 1);
}

TEST_CASE("the Huber norm: square inside, linear outside, smooth between") {
  const auto energy = [](float r) { return huberEnergy(r, huberWeight(r)); };
  CHECK(energy(4) == Approx(16));
  CHECK(energy(-4) == Approx(16));
  CHECK(energy(kHuber) == Approx(kHuber * kHuber));
  CHECK(energy(30) == Approx(2 * kHuber * 30 - kHuber * kHuber));
  const float below = energy(kHuber) - energy(kHuber - 0.01F);
  const float above = energy(kHuber + 0.01F) - energy(kHuber);
  CHECK(below == Approx(above).epsilon(0.01));
}

TEST_CASE("strong gradients weigh less") {
  CHECK(gradientWeight(0) == 1);
  CHECK(gradientWeight(2500) == Approx(0.5));
  CHECK(gradientWeight(4000) < gradientWeight(3000));
}

TEST_CASE("a pattern holds the host's grey levels and weights") {
  const GrayLevel image = test::levelOf(40, 40, [](int u, int v) { return 2 * u + 3 * v; });
  const Pattern pattern = patternAt(image, 20, 10);
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    CHECK(pattern.value[k] == Approx(2 * (20 + kPatternU[k]) + 3 * (10 + kPatternV[k])));
    CHECK(pattern.weight[k] == Approx(gradientWeight(13)));
  }
}

TEST_CASE("a keyframe's state is its first estimate moved by its change") {
  Keyframe keyframe;
  keyframe.T0_camera_world = test::streetPose(2, 0.1).inverse();
  keyframe.affine0 = {0.1, 3};
  keyframe.change << 0.01, 0.02, -0.03, 0.001, 0.002, 0.003, 0.05, -1;
  const Vector6d twist = keyframe.change.head<6>();
  const Eigen::Isometry3d expected = expSe3(twist) * keyframe.T0_camera_world;
  CHECK(keyframe.T_camera_world().isApprox(expected, 1e-12));
  CHECK((keyframe.T_world_camera() * expected).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
  CHECK(keyframe.affine().a == Approx(0.15));
  CHECK(keyframe.affine().b == Approx(2));
  keyframe.relinearise();
  CHECK(keyframe.change.isZero(0));
  CHECK(keyframe.T_camera_world().isApprox(expected, 1e-12));
  CHECK(keyframe.affine().a == Approx(0.15));
}
