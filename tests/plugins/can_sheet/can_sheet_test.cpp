// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the host calls it: position, loops, look-alikes, restarts at an unknown place, and
// saved states.
#include "can_sheet.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <sstream>

#include "support/context.hpp"

using namespace tolman;
using namespace tolman::can_sheet;

namespace {

constexpr int kViews = 60;  // of one lap of 240 m

PlaceObservation view(std::int64_t id, bool known) {
  PlaceObservation seen;
  seen.recognition = known ? Recognition::Familiar : Recognition::Novel;
  seen.template_id = id;
  return seen;
}

struct Fixture {
  explicit Fixture(ParameterValues values = {}) : services(std::move(values)) {
    REQUIRE(cells.configure(services).isOk());
  }
  Decision drive(const PlanarPose& step, const PlaceObservation& seen = {},
                 TrackingState tracking = TrackingState::Tracking) {
    Motion motion;
    motion.frame = frame++;
    motion.stamp_ns = motion.frame * 100'000'000;
    motion.state = motion.frame == 0 ? TrackingState::Initialising : tracking;
    motion.T_previous_current = fromPlanar(step);
    Decision decision;
    const Status status = cells.step(motion, seen, decision);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(decision).empty());
    return decision;
  }
  /// Frame k of laps, every step too long by `drift`.
  Decision lap(int k, double drift, TrackingState tracking = TrackingState::Tracking) {
    const PlanarPose step = {4 * (1 + drift), 0, 2 * std::numbers::pi / kViews};
    return drive(k == 0 ? PlanarPose{} : step, view(k % kViews, k >= kViews), tracking);
  }
  test::TestContext services;
  CanSheet cells;
  std::int64_t frame = 0;
};

/// An experience at each frame of a lap.
ParameterValues small() { return {{"units", std::int64_t{16}}, {"experience_spacing", 3.0}}; }

std::string saved(const CanSheet& cells) {
  std::ostringstream stream;
  REQUIRE(cells.save(stream).isOk());
  return stream.str();
}

Status load(CanSheet& cells, const std::string& text) {
  std::istringstream stream(text);
  return cells.load(stream);
}

}  // namespace

TEST_CASE("without views the modules tell the integrated position and heading") {
  Fixture fixture(small());
  PlanarPose truth;
  for (int i = 0; i < 300; ++i) {
    const PlanarPose step = {1.5, 0.1, i < 150 ? 0.02 : -0.03};
    truth = compose(truth, step);
    const Decision decision = fixture.drive(step);
    REQUIRE(decision.heading == Approx(wrapPeriod(truth.theta, 2 * std::numbers::pi)).margin(1e-9));
  }
  CHECK((fixture.cells.state().position - Eigen::Vector2d(truth.x, truth.y)).norm() < 3);
}

TEST_CASE("familiar views close loops to where they were first seen, and take away drift") {
  Fixture fixture(small());
  int loops = 0;
  for (int k = 0; k < 3 * kViews; ++k) {
    const Decision decision = fixture.lap(k, 0.01);
    if (decision.action != Action::CloseLoop) continue;
    ++loops;
    CHECK(std::abs(decision.experience - k % kViews) <= 2);
  }
  CHECK(loops > 40);
  CHECK(fixture.cells.state().position.norm() < 8);
}

TEST_CASE("single look-alikes close no loop") {
  Fixture fixture(small());
  RandomStream random(5);
  for (int k = 0; k < 120; ++k) {
    const bool alike = k > 60 && k % 4 == 0;
    const auto id = static_cast<std::int64_t>(random.below(40));
    const Decision decision = fixture.drive({4, 0, 0}, alike ? view(id, true) : view(k, false));
    CHECK(decision.action != Action::CloseLoop);
  }
}

TEST_CASE("a robot that is carried to a known place finds out where it is") {
  Fixture fixture(small());
  for (int k = 0; k < kViews; ++k) fixture.lap(k, 0);
  int loops = 0;
  for (int i = 0; i < 20; ++i) {  // to the other side of the lap
    const auto state = i == 0 ? TrackingState::Initialising : TrackingState::Tracking;
    const PlanarPose step = {4, 0, 2 * std::numbers::pi / kViews};
    const Decision decision =
        fixture.drive(i == 0 ? PlanarPose{} : step, view(30 + i, true), state);
    if (i == 0) CHECK(decision.action == Action::CreateExperience);
    if (decision.action != Action::CloseLoop) continue;
    ++loops;
    CHECK(std::abs(decision.experience - (30 + i)) <= 2);
  }
  CHECK(loops >= 3);
}

TEST_CASE("measured poses are passed on from the experience") {
  Fixture fixture(small());
  for (int k = 0; k < kViews; ++k) fixture.lap(k, 0);
  for (int k = kViews; k < kViews + 20; ++k) {
    PlaceObservation seen = view(k % kViews, true);
    seen.has_relative_pose = true;
    seen.T_template_current = fromPlanar({0.5, 0.2, 0.05});
    seen.covariance = 0.1 * Matrix6d::Identity();
    const Decision decision = fixture.drive({4, 0, 2 * std::numbers::pi / kViews}, seen);
    if (decision.action != Action::CloseLoop) continue;
    CHECK(decision.has_relative_pose);
    CHECK(decision.covariance == seen.covariance);
    CHECK(decision.T_experience_current.isApprox(seen.T_template_current, 1e-9));
    return;
  }
  FAIL("no loop was closed");
}

TEST_CASE("a loaded instance answers as the saved one, and damage is refused") {
  Fixture one(small());
  Fixture other(small());
  for (int k = 0; k < 70; ++k) one.lap(k, 0.01);
  const std::string text = saved(one.cells);
  REQUIRE(load(other.cells, text).isOk());
  other.frame = one.frame;
  for (int k = 70; k < 150; ++k) {
    const Decision a = one.lap(k, 0.01);
    const Decision b = other.lap(k, 0.01);
    REQUIRE(a.action == b.action);
    REQUIRE(a.heading == b.heading);
    REQUIRE(a.experience == b.experience);
  }
  CHECK(saved(one.cells) == saved(other.cells));
  for (std::size_t at = 0; at < text.size(); at += 211) {
    std::string bad = text;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    CHECK(load(other.cells, bad).code() == StatusCode::InvalidInput);
  }
  Fixture larger({{"units", std::int64_t{18}}});
  CHECK(load(larger.cells, text).code() == StatusCode::InvalidInput);
  Fixture fresh(small());
  CHECK(saved(larger.cells).size() > saved(fresh.cells).size());
}

TEST_CASE("arrays agree with their descriptions") {
  Fixture fixture(small());
  fixture.drive({});
  std::vector<NamedArray> arrays;
  std::vector<ArrayInfo> infos;
  fixture.cells.arrays(arrays);
  REQUIRE(fixture.cells.describe(infos).isOk());
  REQUIRE(arrays.size() == 5);
  REQUIRE(infos.size() == arrays.size());
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    CHECK(arrays[i].name == infos[i].name);
    CHECK(arrays[i].shape.size() == infos[i].axes.size());
  }
  CHECK(infos[2].axes[0].period == Approx(142));
  CHECK(*std::max_element(arrays[1].values.begin(), arrays[1].values.end()) == 1.0F);
}
