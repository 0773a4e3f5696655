// SPDX-License-Identifier: BSD-3-Clause
#include "host/values.hpp"

#include <catch2/catch.hpp>

#include "tolman/records.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

/// The message about a motion that `change` has changed.
template <class Change>
std::string message(const Change& change) {
  Motion motion;
  change(motion);
  return checkValues(motion).message();
}

}  // namespace

TEST_CASE("NaN, infinity and illegal enumerations name the field") {
  const std::string begin = "the answer has NaN, infinity or an illegal value in ";
  CHECK(message([](Motion&) {}).empty());
  CHECK(message([](Motion& m) { m.v = NAN; }) == begin + "'v'");
  CHECK(message([](Motion& m) { m.T_previous_current(0, 3) = HUGE_VAL; }) ==
        begin + "'T_previous_current'");
  CHECK(message([](Motion& m) { m.state = static_cast<TrackingState>(99); }) == begin + "'state'");
  CHECK(message([](Motion& m) { m.points.setConstant(4, 2, NAN); }) == begin + "'points'");
  CHECK(message([](Motion& m) { m.revisions.resize(2), m.revisions[1].covariance(0, 0) = NAN; }) ==
        begin + "'revisions.covariance'");
}

TEST_CASE("numbers and positions have a limit") {
  CHECK(message([](Motion& m) { m.v = 1e300; }) ==
        "'v' is larger than a record takes: numbers to 1e100, integers to 2^62");
  CHECK(message([](Motion& m) { m.v = -1e100; }).empty());
  CHECK(message([](Motion& m) { m.tracked = INT64_MAX; }).starts_with("'tracked' is larger"));
  CHECK(message([](Motion& m) { m.covariance(3, 3) = 1e200; }).starts_with("'covariance' is"));
  CHECK(message([](Motion& m) { m.points.setConstant(4, 1, 3e38F); }).empty());
  CHECK(message([](Motion& m) { m.T_previous_current.translation().x() = -2e12; }) ==
        "'T_previous_current' is farther than a record takes (1e12 m)");
}

TEST_CASE("a pose that was transposed is none") {
  CHECK(message([](Motion& m) {
          m.T_previous_current.translation().z() = 1;
          m.T_previous_current.matrix().transposeInPlace();
        }) ==
        "the last row of 'T_previous_current' is not 0 0 0 1; the translation is the last "
        "column");
  CHECK(message([](Motion& m) { m.T_previous_current(3, 3) = 2; }).starts_with("the last row"));
}

TEST_CASE("the rotation of a pose is one, up to single precision") {
  const std::string wrong =
      "the rotation of 'T_previous_current' is not orthonormal; use normalised()";
  CHECK(message([](Motion& m) { m.T_previous_current(1, 1) = -1; }) == wrong);  // a mirror
  CHECK(message([](Motion& m) { m.T_previous_current(0, 0) += 1e-3; }) == wrong);
  CHECK(message([](Motion& m) { m.T_previous_current.linear().setZero(); }) == wrong);
  CHECK(message([](Motion& m) {
          const Eigen::AngleAxisf turn(0.7F, Eigen::Vector3f(1, 2, 3).normalized());
          m.T_previous_current.linear() = turn.toRotationMatrix().cast<double>();
        }).empty());
}
