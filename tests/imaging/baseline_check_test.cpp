// SPDX-License-Identifier: BSD-3-Clause
#include "engine/baseline_check.hpp"

#include <catch2/catch.hpp>

using tolman::CameraRig;
using tolman::imaging::baselineDoubt;

namespace {

std::string doubtOf(double baseline) {
  CameraRig rig;
  rig.baseline = baseline;
  return baselineDoubt(rig);
}

}  // namespace

TEST_CASE("a baseline below 1 cm or above 10 m is doubted, with its value and the unit") {
  for (const double usual : {0.0, 0.01, 0.063, 0.54, 10.0}) CHECK(doubtOf(usual).empty());
  CHECK(doubtOf(0.0012).starts_with("the two cameras are 0.0012 m apart"));
  CHECK(doubtOf(50).starts_with("the two cameras are 50 m apart"));
  CHECK(doubtOf(537).find("in metres, not mm") != std::string::npos);
}
