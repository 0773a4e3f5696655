// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <cmath>

#include "conformance/input_sequence.hpp"

using namespace tolman;
using namespace tolman::conformance;

namespace {

CameraRig rig() { return {160, 60, true, {120, 120, 79.5, 29.5}, 0.3}; }

int at(const Image& image, int x, int y) { return image.row(y)[x]; }

/// Grey level between two pixels of a row.
double sample(const Image& image, double x, int y) {
  const int left = static_cast<int>(std::floor(x));
  const double share = x - left;
  return (1 - share) * at(image, left, y) + share * at(image, left + 1, y);
}

}  // namespace

TEST_CASE("the circle is closed, to the left, and starts at the world's origin") {
  CHECK(SyntheticRoom::poseAt(0).isApprox(Eigen::Isometry3d::Identity()));
  const PlanarPose quarter = toPlanar(SyntheticRoom::poseAt(M_PI / 2));
  CHECK(quarter.x == Approx(SyntheticRoom::kRadius));
  CHECK(quarter.y == Approx(SyntheticRoom::kRadius));
  CHECK(quarter.theta == Approx(M_PI / 2));
  CHECK(SyntheticRoom::poseAt(2 * M_PI).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
}

TEST_CASE("the right image is the left one shifted by the disparity of the true depth") {
  const SyntheticRoom room(4);
  const Eigen::Isometry3d T = SyntheticRoom::poseAt(0.7);
  const Image left = room.view(T, rig(), 0);
  const Image right = room.view(T, rig(), rig().baseline);
  double error = 0;
  double error_without = 0;
  int count = 0;
  for (int y = 2; y < 58; y += 3) {
    for (int x = 40; x < 158; x += 3) {
      const double disparity =
          rig().pinhole.fx * rig().baseline / SyntheticRoom::depth(T, rig(), Eigen::Vector2d(x, y));
      error += std::abs(at(left, x, y) - sample(right, x - disparity, y));
      error_without += std::abs(at(left, x, y) - at(right, x, y));
      ++count;
    }
  }
  CHECK(error / count < 6);  // grey levels; corners between walls and interpolation
  CHECK(error < 0.25 * error_without);
}

TEST_CASE("depth is the distance to the wall along the optical axis") {
  // The room reaches 5.5 m ahead of the first camera.
  CHECK(SyntheticRoom::depth(Eigen::Isometry3d::Identity(), rig(), {79.5, 29.5}) == Approx(5.5));
  CHECK(SyntheticRoom::depth(fromPlanar({1, 0, 0}), rig(), {79.5, 29.5}) == Approx(4.5));
}

TEST_CASE("all walls have texture, different for each seed") {
  const Image image = SyntheticRoom(1).view(SyntheticRoom::poseAt(2), rig(), 0);
  const Image other = SyntheticRoom(2).view(SyntheticRoom::poseAt(2), rig(), 0);
  int equal = 0;
  int least = 255;
  int most = 0;
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 160; ++x) {
      least = std::min(least, at(image, x, y));
      most = std::max(most, at(image, x, y));
      equal += at(image, x, y) == at(other, x, y) ? 1 : 0;
    }
  }
  CHECK(most - least > 120);
  CHECK(equal < 0.05 * 60 * 160);
}
