// SPDX-License-Identifier: BSD-3-Clause
// Poses found by features where the expectation is far off, or something covers a part of the view.
#include "feature_guess.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

struct GuessCase {
  CameraRig rig = test::streetRig();
  std::unique_ptr<Window> window = test::streetWindow({test::streetPose(0), test::streetPose(0.5)});

  GuessCase() { test::addTruePoints(*window, 400); }
  /// The pose of the newest keyframe in the frame, as guessed for the image.
  std::optional<Eigen::Isometry3d> guess(const GrayLevel& image) const {
    return guessByFeatures(rig, *window, image, Eigen::Isometry3d::Identity());
  }
};

double metresOff(const Eigen::Isometry3d& T_current_reference, const Eigen::Isometry3d& truth) {
  const Eigen::Isometry3d T_reference_current = test::streetPose(0.5).inverse() * truth;
  return (T_current_reference * T_reference_current).translation().norm();
}

GrayLevel levelAt(const Eigen::Isometry3d& T_world_camera) {
  return test::streetPyramid(T_world_camera).level(0);
}

}  // namespace

TEST_CASE("turns and steps that were not expected are found") {
  const GuessCase c;
  for (const auto& [z, yaw] : {std::pair(0.5, 0.06), std::pair(1.4, 0.0), std::pair(0.9, -0.04)}) {
    const Eigen::Isometry3d pose = test::streetPose(z, yaw);
    CAPTURE(z, yaw);
    const auto guess = c.guess(levelAt(pose));
    REQUIRE(guess);
    CHECK(metresOff(*guess, pose) < 0.05);
    CHECK(logSo3((*guess * test::streetPose(0.5).inverse() * pose).linear()).norm() < 0.005);
  }
}

TEST_CASE("what covers a third of the view does not mislead") {
  const GuessCase c;
  const Eigen::Isometry3d pose = test::streetPose(0.9, 0.02);
  GrayLevel image = levelAt(pose);
  for (int v = 0; v < image.height; ++v) {
    std::fill_n(image.row(v) + image.width / 3, image.width / 3, std::uint8_t{60});
  }
  const auto guess = c.guess(image);
  REQUIRE(guess);
  CHECK(metresOff(*guess, pose) < 0.05);
}

TEST_CASE("no guess without points that agree") {
  GuessCase c;
  CHECK_FALSE(c.guess(test::levelOf(c.rig.width, c.rig.height, [](int, int) { return 90; })));
  RandomStream random(3);
  CHECK_FALSE(c.guess(test::levelOf(
      c.rig.width, c.rig.height, [&](int, int) { return static_cast<int>(random.below(256)); })));
  for (const int slot : c.window->order()) c.window->keyframe(slot).points.clear();
  CHECK_FALSE(c.guess(levelAt(test::streetPose(0.5))));
}
