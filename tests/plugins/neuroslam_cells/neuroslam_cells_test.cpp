// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the host calls it: heading and height follow the motion, laps give loops, similar
// storeys of a car park are kept apart, and after a reset the answers are the same bit by bit.
#include "neuroslam_cells.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/context.hpp"

using namespace tolman;
using namespace tolman::neuroslam_cells;

namespace {

struct Fixture {
  explicit Fixture(const ParameterValues& values = {}) : services(values) {
    REQUIRE(cells.configure(services).isOk());
  }
  Decision drive(const Eigen::Isometry3d& step, std::int64_t view = -1, bool known = false) {
    Motion motion;
    motion.frame = frame;
    motion.stamp_ns = 7 + frame++ * 100'000'000;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = step;
    PlaceObservation seen;
    if (view >= 0) {
      seen.recognition = known ? Recognition::Familiar : Recognition::Novel;
      seen.template_id = view;
    }
    Decision decision;
    const Status status = cells.step(motion, seen, decision);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(decision).empty());
    return decision;
  }
  std::vector<float> array(const char* name) const {
    std::vector<NamedArray> all;
    cells.arrays(all);
    for (const NamedArray& array : all) {
      if (array.name == name) return array.values;
    }
    FAIL("no array " << name);
    return {};
  }

  test::TestContext services;
  NeuroslamCells cells;
  std::int64_t frame = 0;
};

constexpr int kLap = 40;

/// On a circle of 60 m round, `climb` m higher after each lap.
Eigen::Isometry3d onRamp(int k, double climb) {
  const double angle = 2 * std::numbers::pi * k / kLap;
  constexpr double kRadius = 60 / (2 * std::numbers::pi);
  Eigen::Isometry3d T =
      fromPlanar({kRadius * std::sin(angle), kRadius - kRadius * std::cos(angle), angle});
  T.translation().y() = -climb * k / kLap;
  return T;
}

struct Loops {
  int right = 0;
  int wrong = 0;  ///< to a place of the same look on another storey
};

/// Up `storeys` laps and down again by the same way; the views of all laps look alike.
Loops carPark(int storeys, double climb) {
  Fixture fixture;
  std::vector<double> height;  // of each experience
  Loops loops;
  Eigen::Isometry3d before = onRamp(0, climb);
  for (int lap = 0; lap < 2; ++lap) {
    for (int k = 0; k <= storeys * kLap; ++k) {
      const Eigen::Isometry3d here = onRamp(k, climb);
      // Between the laps the car is lifted down to the begin, and odometry sees it.
      const Decision decision =
          fixture.drive(before.inverse() * here, k % kLap, lap > 0 || k >= kLap);
      before = here;
      const double now = -here.translation().y();
      if (decision.action == Action::CreateExperience) {
        height.push_back(now);
      } else if (decision.action == Action::CloseLoop) {
        const double there = height[static_cast<std::size_t>(decision.experience)];
        ++(std::abs(there - now) <= 0.5 * climb ? loops.right : loops.wrong);
      }
    }
  }
  return loops;
}

}  // namespace

TEST_CASE("the first frame creates experience 0, with or without a view, at the data's time") {
  Fixture blind;
  const Decision first = blind.drive(Eigen::Isometry3d::Identity());
  CHECK(first.action == Action::CreateExperience);
  CHECK(first.experience == 0);
  CHECK(first.stamp_ns == 7);
  CHECK(blind.drive(fromPlanar({1, 0, 0})).action == Action::Stay);
  Fixture seeing;
  CHECK(seeing.drive(Eigen::Isometry3d::Identity(), 0).experience == 0);
}

TEST_CASE("heading and height follow the motion") {
  Fixture fixture;
  fixture.drive(Eigen::Isometry3d::Identity());
  Eigen::Isometry3d step = fromPlanar({1, 0, 0.3});
  step.translation().y() = -0.5;  // a cell higher with each frame
  Decision decision;
  for (int k = 0; k < 10; ++k) decision = fixture.drive(step);
  CHECK(std::abs(wrapAngle(decision.heading - 3)) < 0.2);
  const std::vector<float> height = fixture.array("grid.height");
  const auto highest = std::ranges::max_element(height) - height.begin();
  CHECK(std::abs(highest - (18 + 10)) <= 1);
}

TEST_CASE("without motion the packets stay where they are") {
  Fixture fixture;
  fixture.drive(Eigen::Isometry3d::Identity());
  for (int k = 0; k < 200; ++k) fixture.drive(Eigen::Isometry3d::Identity());
  const std::vector<float> place = fixture.array("pose.estimate");
  CHECK(place[0] == Approx(18).margin(0.01));
  CHECK(place[1] == Approx(18).margin(0.01));
  CHECK(place[2] == Approx(18).margin(0.01));
  CHECK(std::abs(std::remainder(place[3], 36.0F)) < 0.01);
}

TEST_CASE("laps in the plane close") {
  const Loops loops = carPark(3, 0);
  CHECK(loops.right > 2 * kLap);
}

TEST_CASE("storeys that look alike are kept apart while odometry is right") {
  const Loops loops = carPark(3, 3);
  CAPTURE(loops.right, loops.wrong);
  CHECK(loops.wrong == 0);
}

TEST_CASE("a reset gives the same answers bit by bit") {
  Fixture fixture;
  const auto pass = [&] {
    REQUIRE(fixture.cells.reset().isOk());
    fixture.frame = 0;
    for (int k = 0; k < 60; ++k) {
      fixture.drive(k == 0 ? Eigen::Isometry3d::Identity() : fromPlanar({1.5, 0, 0.15}), k % 40,
                    k >= 40);
    }
    return fixture.array("hd.layers");
  };
  CHECK(pass() == pass());
}

TEST_CASE("negative templates are refused") {
  Fixture fixture;
  PlaceObservation seen;
  seen.recognition = Recognition::Familiar;
  seen.template_id = -3;
  Decision decision;
  CHECK(fixture.cells.step({}, seen, decision).message() ==
        "a view was recognised, but its template_id is negative");
}
