// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/room.hpp"

#include <catch2/catch.hpp>
#include <cmath>

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
  CHECK(Room::poseAt(0).isApprox(Eigen::Isometry3d::Identity()));
  const PlanarPose quarter = toPlanar(Room::poseAt(M_PI / 2));
  CHECK(quarter.x == Approx(Room::kRadius));
  CHECK(quarter.y == Approx(Room::kRadius));
  CHECK(quarter.theta == Approx(M_PI / 2));
  CHECK(Room::poseAt(2 * M_PI).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
}

TEST_CASE("the two cameras see the same walls, displaced by the disparity of the true depth") {
  const Room room(4);
  const Eigen::Isometry3d T = Room::poseAt(0.7);
  const Image left = room.view(T, rig(), 0, PixelFormat::Gray8);
  const Image right = room.view(T, rig(), rig().baseline, PixelFormat::Gray8);
  double error = 0;
  double error_without = 0;
  int count = 0;
  for (int y = 2; y < 58; y += 3) {
    for (int x = 40; x < 158; x += 3) {
      const double disparity =
          rig().pinhole.fx * rig().baseline / Room::depth(T, rig(), Eigen::Vector2d(x, y));
      error += std::abs(at(left, x, y) - sample(right, x - disparity, y));
      error_without += std::abs(at(left, x, y) - at(right, x, y));
      ++count;
    }
  }
  CHECK(error / count < 6);  // grey levels; corners between walls and interpolation
  CHECK(error < 0.25 * error_without);
}

TEST_CASE("depth is the distance to the wall ahead") {
  // The room reaches 5.5 m ahead of the first camera.
  CHECK(Room::depth(Eigen::Isometry3d::Identity(), rig(), {79.5, 29.5}) == Approx(5.5));
  CHECK(Room::depth(fromPlanar({1, 0, 0}), rig(), {79.5, 29.5}) == Approx(4.5));
}

TEST_CASE("walls have texture everywhere, another one for each seed") {
  const Image image = Room(1).view(Room::poseAt(2), rig(), 0, PixelFormat::Gray8);
  const Image other = Room(2).view(Room::poseAt(2), rig(), 0, PixelFormat::Gray8);
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

TEST_CASE("colour has three equal channels") {
  const Image grey = Room(1).view(Room::poseAt(1), rig(), 0, PixelFormat::Gray8);
  const Image colour = Room(1).view(Room::poseAt(1), rig(), 0, PixelFormat::Bgr8);
  for (int x = 0; x < 160; x += 7) {
    for (int c = 0; c < 3; ++c) CHECK(colour.row(30)[3 * x + c] == at(grey, x, 30));
  }
}
