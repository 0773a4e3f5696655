// SPDX-License-Identifier: BSD-3-Clause
// Static stereo confirms the right pose and rejects wrong ones.
#include <catch2/catch.hpp>

#include "static_stereo.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

constexpr int kDisparities = 100;

struct CheckCase {
  CameraRig rig = test::streetRig();
  std::unique_ptr<Window> window = test::streetWindow({test::streetPose(0), test::streetPose(0.5)});
  ImagePyramid left;
  ImagePyramid right;

  CheckCase() {
    test::addTruePoints(*window, 400);
    see(test::streetPose(3));
  }
  void see(const Eigen::Isometry3d& pose) {
    const Frame frame = test::streetFrame(2, pose);
    left.build(frame.left);
    right.build(frame.right, 1);
  }
  StereoAgreement at(const Eigen::Isometry3d& believed) const {
    return compareWithStereo(rig, *window, believed, left.level(0), right.level(0), kDisparities);
  }
};

}  // namespace

TEST_CASE("the right pose is confirmed by most points") {
  const CheckCase c;
  const StereoAgreement agreement = c.at(test::streetPose(3));
  CHECK(agreement.compared >= 100);
  CHECK(agreement.agreeing > 0.9 * agreement.compared);
  CHECK(agreement.confirms());
}

TEST_CASE("poses at a wrong place are not") {
  const CheckCase c;
  for (const double metres : {-3.0, 3.0}) {  // sideways: along the street all looks the same
    const Eigen::Isometry3d beside = Eigen::Translation3d(metres, 0, 0) * test::streetPose(3);
    CHECK_FALSE(c.at(beside).confirms());
  }
  CHECK_FALSE(c.at(test::streetPose(3, 1.5)).confirms());  // looks at a wall
}

TEST_CASE("an offset of all disparities is taken into account") {
  CheckCase c;
  c.window->field.startFrom(30);
  CHECK_FALSE(c.at(test::streetPose(3)).confirms());
}

TEST_CASE("without points, or with sides that do not match, nothing is confirmed") {
  CheckCase c;
  c.right.build(test::streetFrame(2, test::streetPose(30, 1.5)).right, 1);
  CHECK_FALSE(c.at(test::streetPose(3)).confirms());
  c.see(test::streetPose(3));
  for (const int slot : c.window->order()) c.window->keyframe(slot).points.clear();
  const StereoAgreement nothing = c.at(test::streetPose(3));
  CHECK(nothing.compared == 0);
  CHECK_FALSE(nothing.confirms());
}
