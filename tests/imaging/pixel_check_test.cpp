// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_check.hpp"

#include <catch2/catch.hpp>

using tolman::CameraRig;
using tolman::imaging::pixelDoubt;

namespace {

std::string pixelDoubtOf(double fx, double fy, bool calibrated = true) {
  CameraRig rig;
  rig.calibrated = calibrated;
  rig.pinhole.fx = fx;
  rig.pinhole.fy = fy;
  return pixelDoubt(rig);
}

}  // namespace

TEST_CASE("focal lengths that differ by more than 5 % are doubted, in either direction") {
  CHECK(pixelDoubtOf(700, 700).empty());
  CHECK(pixelDoubtOf(700, 734).empty());
  CHECK(pixelDoubtOf(734, 700).empty());
  CHECK(pixelDoubtOf(707.1, 1414.2)
            .starts_with("the focal lengths of the rectified images are "
                         "707.1 px horizontally and 1414.2 px vertically"));
  CHECK_FALSE(pixelDoubtOf(740, 700).empty());
  CHECK(pixelDoubtOf(700, 1400, false).empty());
  CHECK(pixelDoubtOf(0, 0).empty());
}
