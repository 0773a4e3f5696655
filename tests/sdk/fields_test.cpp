// SPDX-License-Identifier: BSD-3-Clause
// Records: each lists all of its members, and the check at the boundary sees every one.
#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

using namespace tolman;

namespace {

/// Converts to anything, to count how many initialisers an aggregate takes.
struct Anything {
  template <class T>
  operator T() const;  // NOLINT: that is the point; never called
};

template <class R, class... Args>
constexpr std::size_t memberCount() {
  if constexpr (requires { R{Args{}..., Anything{}}; }) {
    return memberCount<R, Args..., Anything>();
  } else {
    return sizeof...(Args);
  }
}

template <class R>
std::vector<std::string> fieldNames() {
  std::vector<std::string> names;
  const R record;
  visitFields(record, [&](const Field& field, const auto&) { names.emplace_back(field.name); });
  return names;
}

}  // namespace

TEMPLATE_TEST_CASE("a record declares every member once, with a line of documentation", "", Frame,
                   MotionRevision, Motion, Candidate, PlaceObservation, EarlierLoop,
                   PlaceHypothesis, Decision, Experience, Link, MapUpdate, MapGraph, NamedArray,
                   ArrayAxis, ArrayInfo, Finding, SourceInfo, RawRig, RunInfo) {
  const auto names = fieldNames<TestType>();
  CHECK(names.size() == memberCount<TestType>());
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
  const TestType record;
  visitFields(record, [](const Field& field, const auto&) {
    INFO(field.name);
    CHECK(field.doc.size() > 5);
  });
}

TEST_CASE("a fresh record is valid") {
  CHECK(firstInvalidField(Motion{}).empty());
  CHECK(firstInvalidField(Frame{}).empty());
  CHECK(firstInvalidField(Link{}).empty());
}

TEST_CASE("the first invalid field is named, however deep the number lies") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Motion motion;
  SECTION("scalar") {
    motion.v = std::numeric_limits<double>::infinity();
    CHECK(firstInvalidField(motion) == "v");
  }
  SECTION("pose") {
    motion.T_previous_current.matrix()(1, 2) = kNan;
    CHECK(firstInvalidField(motion) == "T_previous_current");
  }
  SECTION("matrix of dynamic size") {
    motion.points.setZero(4, 7);
    CHECK(firstInvalidField(motion).empty());
    motion.points(2, 5) = std::numeric_limits<float>::quiet_NaN();
    CHECK(firstInvalidField(motion) == "points");
  }
  SECTION("record in a list in a record") {
    motion.revisions.resize(3);
    motion.revisions[2].covariance(5, 5) = kNan;
    CHECK(firstInvalidField(motion) == "revisions");
  }
  SECTION("enumeration out of its range") {
    motion.state = static_cast<TrackingState>(9);
    CHECK(firstInvalidField(motion) == "state");
    CHECK(enumName(motion.state) == "invalid");
  }
  SECTION("named array") {
    Frame frame;
    frame.sensors.push_back({"gyroscope", {2}, {0, std::numeric_limits<float>::infinity()}});
    CHECK(firstInvalidField(frame) == "sensors");
  }
}

TEST_CASE("planar velocity has the signs of the documentation") {
  Motion motion;
  motion.T_previous_current = fromPlanar({1.0, 0.2, 0.1});
  setPlanarVelocity(motion, 0.5);
  CHECK(motion.v == Approx(std::hypot(1.0, 0.2) / 0.5));
  CHECK(motion.omega == Approx(0.2));
  motion.T_previous_current = fromPlanar({-1.0, 0, 0});
  setPlanarVelocity(motion, 0.5);
  CHECK(motion.v == Approx(-2));  // reversing
  setPlanarVelocity(motion, 0);
  CHECK(motion.v == 0);
}
