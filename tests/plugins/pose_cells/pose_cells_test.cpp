// SPDX-License-Identifier: BSD-3-Clause
// The plugin as the host calls it, on small drives.
#include "pose_cells.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <stdexcept>

#include "support/context.hpp"

using namespace tolman;
using namespace tolman::pose_cells;

namespace {

Motion motionOf(const PlanarPose& step, std::int64_t frame) {
  Motion motion;
  motion.frame = frame;
  motion.stamp_ns = 1000 + frame * 100'000'000;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current = fromPlanar(step);
  return motion;
}

PlaceObservation view(std::int64_t id, bool known) {
  PlaceObservation seen;
  seen.recognition = known ? Recognition::Familiar : Recognition::Novel;
  seen.template_id = id;
  return seen;
}

struct Fixture {
  explicit Fixture(const ParameterValues& values = {}) : services(values) {
    REQUIRE(cells.configure(services).isOk());
  }
  Decision drive(const PlanarPose& step, const PlaceObservation& seen = {}) {
    Decision decision;
    const Status status = cells.step(motionOf(step, frame++), seen, decision);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(decision).empty());
    return decision;
  }
  test::TestContext services;
  PoseCells cells;
  std::int64_t frame = 0;
};

/// A round course of 40 views, driven `laps` times; every step `drift` too long.
int loopsOf(Fixture& fixture, int laps, double drift) {
  int loops = 0;
  for (int k = 0; k < 40 * laps; ++k) {
    const PlanarPose step = {k == 0 ? 0 : 1.5 * (1 + drift), 0,
                             k == 0 ? 0 : 2 * std::numbers::pi / 40};
    const Decision decision = fixture.drive(step, view(k % 40, k >= 40));
    if (decision.action != Action::CloseLoop) continue;
    CHECK(std::abs(decision.experience - k % 40) <= 1);
    ++loops;
  }
  return loops;
}

}  // namespace

TEST_CASE("the first frame creates experience 0, with or without a view") {
  Fixture blind;
  const Decision first = blind.drive({0, 0, 0});
  CHECK(first.action == Action::CreateExperience);
  CHECK(first.experience == 0);
  CHECK(blind.drive({1, 0, 0}).action == Action::Stay);
  Fixture seeing;
  CHECK(seeing.drive({0, 0, 0}, view(0, false)).experience == 0);
}

TEST_CASE("heading follows the turns, positive to the left, 0 at the start") {
  Fixture fixture;
  double heading = 0;
  CHECK(fixture.drive({0, 0, 0}).heading == Approx(0).margin(1e-3));
  for (int k = 0; k < 50; ++k) {
    heading += 0.1;
    const Decision decision = fixture.drive({0.2, 0, 0.1});
    CHECK(std::abs(wrapAngle(decision.heading - heading)) < 0.09);  // half a cell of 10 deg
  }
}

TEST_CASE("the second lap finds the experiences of the first") {
  Fixture fixture;
  CHECK(loopsOf(fixture, 3, 0) > 60);
}

TEST_CASE("the turn of one view does not leak into the next (defect 6)") {
  Fixture fixture;
  fixture.drive({}, view(0, false));
  CHECK(fixture.drive({10, 0, 0}, view(1, false)).action == Action::CreateExperience);
  PlaceObservation turned = view(1, true);
  turned.relative_yaw = 3 * 2 * std::numbers::pi / 36;
  CHECK(fixture.drive({0, 0, turned.relative_yaw}, turned).action == Action::Stay);
  CHECK(fixture.drive({}, view(1, true)).action == Action::CreateExperience);
}

TEST_CASE("stamps are the data's (defect 9), and a reset gives the same answers bit by bit") {
  Fixture fixture;
  const Decision decision = fixture.drive({0, 0, 0}, view(0, false));
  CHECK(decision.stamp_ns == 1000);
  REQUIRE(fixture.cells.reset().isOk());
  fixture.frame = 0;
  const int loops = loopsOf(fixture, 2, 0.02);
  std::vector<NamedArray> first;
  fixture.cells.arrays(first);
  REQUIRE(fixture.cells.reset().isOk());
  fixture.frame = 0;
  CHECK(loopsOf(fixture, 2, 0.02) == loops);
  std::vector<NamedArray> second;
  fixture.cells.arrays(second);
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(first[i].values == second[i].values);
}

namespace {

const ParameterValues kPublished = {
    {"least_shift", 0.0}, {"unsupported", 1.0}, {"injected_energy", 0.15}};

/// How far the estimate moves along x, in cells, while `known` views in a row, one every
/// `interval` frames, show a street that was left behind 20 m before.
float movedBy(ParameterValues values, int known, int interval) {
  values["newest_ignored"] = std::int64_t{0};
  Fixture fixture(values);
  const auto x = [&] {
    std::vector<NamedArray> arrays;
    fixture.cells.arrays(arrays);
    return arrays[2].values[0];
  };
  for (int k = 0; k < 20; ++k) fixture.drive({k == 0 ? 0.0 : 1.0, 0, 0}, view(k, false));
  for (int k = 0; k < 15; ++k) fixture.drive({1, 0, 0});
  const float before = x();
  for (int k = 0; k < known * interval; ++k) {
    fixture.drive({0, 0, 0},
                  k % interval == 0 ? view(k / interval % 2 + 4, true) : PlaceObservation{});
  }
  return std::abs(x() - before);
}

}  // namespace

TEST_CASE("as published, three look-alikes in a row move the packet; now many are needed") {
  CHECK(movedBy(kPublished, 1, 1) < 0.5F);
  CHECK(movedBy(kPublished, 3, 1) > 5);
  for (const int known : {1, 2, 3}) CHECK(movedBy({}, known, 1) < 0.5F);
  for (const int known : {1, 2, 3, 4}) CHECK(movedBy({}, known, 5) < 0.5F);
  CHECK(movedBy({}, 15, 1) > 5);
}

TEST_CASE("slow turns and motions are integrated in full, as published they fall short") {
  const double step = GENERATE(0.01, 0.03, 0.05);  // cells a frame, or headings
  const int frames = static_cast<int>(std::lround(8 / step));
  const auto turned = [&](const ParameterValues& values) {
    Fixture fixture(values);
    double heading = 0;
    for (int k = 0; k < frames; ++k) {
      heading = fixture.drive({0, 0, step * std::numbers::pi / 18}).heading;
    }
    return heading * 18 / std::numbers::pi;
  };
  CHECK(turned({}) == Approx(8).epsilon(0.03));
  CHECK(turned(kPublished) < 8 * 0.95);
  Fixture straight;
  for (int k = 0; k < frames; ++k) straight.drive({2 * step, 0, 0});
  std::vector<NamedArray> arrays;
  straight.cells.arrays(arrays);
  CHECK(arrays[2].values[0] - 15 == Approx(8).epsilon(0.03));
}

TEST_CASE("wrong input is refused with the reason") {
  Fixture fixture;
  Decision decision;
  CHECK(fixture.cells.step(motionOf({}, 0), view(-1, true), decision).code() ==
        StatusCode::InvalidInput);
}

// The packet sticks a little to the cells: places are right within a third of one.
TEST_CASE("the arrays: sums over the other axes, peak one, where the robot is") {
  Fixture fixture({{"side", std::int64_t{20}}, {"headings", std::int64_t{24}}});
  fixture.drive({0, 0, 0});
  for (int k = 0; k < 6; ++k) fixture.drive({2, 0, 0});                      // 6 cells along x
  for (int k = 0; k < 6; ++k) fixture.drive({0, 0, std::numbers::pi / 12});  // a quarter turn
  for (int k = 0; k < 3; ++k) fixture.drive({2, 0, 0});                      // 3 cells along y
  std::vector<NamedArray> arrays;
  fixture.cells.arrays(arrays);
  REQUIRE(arrays.size() == 3);
  CHECK(arrays[0].name == "hd.activity");
  REQUIRE(arrays[0].values.size() == 24);
  const auto ring = std::max_element(arrays[0].values.begin(), arrays[0].values.end());
  CHECK(*ring == 1);
  CHECK(ring - arrays[0].values.begin() == 6);
  CHECK(arrays[1].shape == std::vector<int>{20, 20});
  const auto sheet = std::max_element(arrays[1].values.begin(), arrays[1].values.end());
  CHECK(sheet - arrays[1].values.begin() == 13 * 20 + 16);  // from the middle, (10, 10)
  CHECK(arrays[2].values[0] == Approx(16).margin(0.3));
  CHECK(arrays[2].values[1] == Approx(13).margin(0.3));
  CHECK(arrays[2].values[2] == Approx(6).margin(0.3));
}

TEST_CASE("a torus: after a whole period straight on the packet is back") {
  Fixture fixture({{"side", std::int64_t{15}}, {"cell_size", 1.0}});
  fixture.drive({0, 0, 0});
  std::vector<NamedArray> start;
  fixture.cells.arrays(start);
  for (int k = 0; k < 20; ++k) fixture.drive({0.75, 0, 0});
  std::vector<NamedArray> round;
  fixture.cells.arrays(round);
  CHECK(round[2].values[0] == Approx(start[2].values[0]).margin(0.3));
  CHECK(round[2].values[1] == Approx(start[2].values[1]).margin(0.3));
}
