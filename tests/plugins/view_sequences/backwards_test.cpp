// SPDX-License-Identifier: BSD-3-Clause
// The plugin in a rendered street that is driven in both directions: only this street is
// recognised, with its pose and only with a stereo pair; saved states continue at any frame.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "house_street.hpp"
#include "tour.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

constexpr int kLength = 110;  // m

ParameterValues backwards(bool on = true) {
  return {{"backwards", on}, {"probability", 0.999}, {"probability_backwards", 0.95}};
}

struct Step {
  Frame frame;
  Eigen::Isometry3d T_street_camera;
};

/// One image a metre, out in the right lane or back in the other one.
std::vector<Step> stepsOf(std::uint64_t seed, bool turned) {
  const HouseStreet street(seed);
  std::vector<Step> steps;
  for (int i = 0; i < kLength; ++i) {
    const Eigen::Isometry3d T =
        HouseStreet::poseAt(turned ? kLength - i + 0.4 : i, turned ? -1.5 : 1.5, turned);
    steps.push_back({street.frameAt(T), T});
  }
  return steps;
}

const std::vector<Step>& out() {
  static const std::vector<Step> steps = stepsOf(1, false);
  return steps;
}
const std::vector<Step>& back() {
  static const std::vector<Step> steps = stepsOf(1, true);
  return steps;
}

struct Seen {
  std::vector<PlaceObservation> familiar;
  std::vector<Eigen::Isometry3d> T_street_camera;  ///< of the familiar ones
};

/// Drives the steps as a pass of its own; adds the poses of templates to `made_at`.
Seen drive(Tour& tour, const std::vector<Step>& steps, std::vector<Eigen::Isometry3d>& made_at) {
  Seen seen;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const PlaceObservation answer = tour.drive(steps[i].frame, 1, i == 0);
    if (answer.recognition == Recognition::Novel) made_at.push_back(steps[i].T_street_camera);
    if (answer.recognition != Recognition::Familiar) continue;
    seen.familiar.push_back(answer);
    seen.T_street_camera.push_back(steps[i].T_street_camera);
  }
  return seen;
}

}  // namespace

TEST_CASE("a street that is driven back is recognised, and the pose is true", "[figures]") {
  Tour tour(backwards(), houseRig());
  CHECK(tour.log().empty());
  std::vector<Eigen::Isometry3d> made_at;
  CHECK(drive(tour, out(), made_at).familiar.empty());
  const Seen seen = drive(tour, back(), made_at);
  REQUIRE(seen.familiar.size() >= 8);
  for (std::size_t i = 0; i < seen.familiar.size(); ++i) {
    const PlaceObservation& answer = seen.familiar[i];
    REQUIRE(answer.has_relative_pose);
    CHECK(answer.score <= 0.05);
    CHECK(std::abs(wrapAngle(answer.relative_yaw - std::numbers::pi)) < 0.1);
    const Eigen::Isometry3d expected =
        made_at[std::size_t(answer.template_id)].inverse() * seen.T_street_camera[i];
    const Vector6d error = logSe3(answer.T_template_current.inverse() * expected);
    CAPTURE(i, answer.template_id, error.transpose());
    CHECK(std::abs(error[0]) < 0.8);
    CHECK(std::abs(error[2]) < 4.5);  // houses of 4 m show one end to each direction
    CHECK(error.tail<3>().norm() < 0.1);
    CHECK(answer.covariance(2, 2) > answer.covariance(0, 0));
  }
  // Stored in this direction as well, except where it was recognised.
  CHECK(made_at.size() + seen.familiar.size() == 2 * std::size_t(kLength));
}

TEST_CASE("another street is not recognised, nor the same one when this is off", "[figures]") {
  const std::vector<Step> other = stepsOf(2, true);
  std::vector<Eigen::Isometry3d> made_at;
  Tour elsewhere(backwards(), houseRig());
  drive(elsewhere, out(), made_at);
  CHECK(drive(elsewhere, other, made_at).familiar.empty());
  Tour off(backwards(false), houseRig());
  drive(off, out(), made_at);
  CHECK(drive(off, back(), made_at).familiar.empty());
}

TEST_CASE("one camera recognises nothing the other way, and says why") {
  CameraRig single = houseRig();
  single.baseline = 0;
  Tour tour(backwards(), single);
  REQUIRE(tour.log().size() == 1);
  CHECK(tour.log()[0] ==
        "streets driven the other way need a calibrated stereo pair and are not recognised: set "
        "backwards to false");
  std::vector<Eigen::Isometry3d> made_at;
  drive(tour, out(), made_at);
  CHECK(drive(tour, back(), made_at).familiar.empty());
  Tour again(backwards(), single);
  REQUIRE(again.load(tour.saved()).isOk());
  CHECK(again.saved() == tour.saved());
}

TEST_CASE("a way back that is continued from a state is the whole one, to the bit") {
  Tour whole(backwards(), houseRig());
  std::vector<Eigen::Isometry3d> made_at;
  drive(whole, out(), made_at);
  for (std::size_t i = 0; i < back().size(); ++i) {
    const std::string state = i % 13 == 5 ? whole.saved() : "";
    const std::int64_t frame = whole.frames();
    const PlaceObservation a = whole.drive(back()[i].frame, 1, i == 0);
    if (state.empty()) continue;
    Tour continued(backwards(), houseRig());
    continued.drive(out()[0].frame, 1, true);  // forgotten
    REQUIRE(continued.load(state).isOk());
    continued.continueAt(frame);
    REQUIRE(continued.saved() == state);
    const PlaceObservation b = continued.drive(back()[i].frame, 1, i == 0);
    CHECK(a.template_id == b.template_id);
    CHECK(a.score == b.score);
    CHECK(a.T_template_current.matrix() == b.T_template_current.matrix());
    CHECK(continued.saved() == whole.saved());
  }
}

TEST_CASE("states with and without structure are not mixed up, and damaged ones are refused") {
  Tour with(backwards(), houseRig());
  Tour without(backwards(false), houseRig());
  for (int i = 0; i < 20; ++i) {
    with.drive(out()[std::size_t(i)].frame, 1, i == 0);
    without.drive(out()[std::size_t(i)].frame, 1, i == 0);
  }
  const Status older = with.load(without.saved());
  CHECK(older.message() ==
        "the saved state has version 3, this plugin reads version 4 (version 4: saved with "
        "`backwards`, 3: without)");
  CHECK_FALSE(without.load(Tour(backwards(), houseRig()).saved()).isOk());
  Tour fresh(backwards(), houseRig());
  CHECK(with.saved() == fresh.saved());  // a refused state leaves nothing behind
}

TEST_CASE("blank images, and motions of unknown length, are no structure") {
  for (const bool blank : {true, false}) {
    Tour tour(backwards(), houseRig());
    std::vector<Eigen::Isometry3d> made_at;
    int familiar = 0;
    for (const auto* steps : {&out(), &back()}) {
      for (std::size_t i = 0; i < steps->size(); ++i) {
        Frame frame = (*steps)[i].frame;
        Motion motion;
        motion.state = i == 0 ? TrackingState::Initialising : TrackingState::Tracking;
        motion.T_previous_current.translation().z() = i == 0 ? 0 : 1;
        motion.scale_known = blank;
        if (blank) frame.right = Image();
        PlaceObservation seen;
        REQUIRE(tour.observe(frame, motion, seen).isOk());
        familiar += seen.recognition == Recognition::Familiar && std::abs(seen.relative_yaw) > 1;
      }
    }
    CHECK(familiar == 0);
  }
}
