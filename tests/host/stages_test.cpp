// SPDX-License-Identifier: BSD-3-Clause
// Contracts at the plugin boundary, with plugins that violate them.
#include "host/stages.hpp"

#include <cmath>
#include <numbers>

#include "host/fixture_plugins.hpp"
#include "host/frame_at.hpp"
#include "support/context.hpp"

using namespace tolman;
using namespace tolman::host;
using tolman::test::frameAt;
using tolman::test::load;

namespace {

std::unique_ptr<Instance> instanceOf(const std::string& library, const std::string& id) {
  return Instance::create(load(library, id), "odometry");
}

/// Tracks frames 0 ... 4 and returns the first failure.
Status drive(const std::string& id) {
  OdometryStage odometry(instanceOf("misbehaving", id));
  test::TestContext context;
  Status status = odometry.instance().configure(context);
  for (std::int64_t k = 0; k < 5 && status.isOk(); ++k) {
    Motion motion;
    status = odometry.track(frameAt(k), motion);
  }
  return status;
}

}  // namespace

TEST_CASE("a sound plugin answers and takes its parameters") {
  OdometryStage odometry(instanceOf("steady", "steady"));
  test::TestContext context({{"speed", 20.0}});
  REQUIRE(odometry.instance().configure(context).isOk());
  Motion motion;
  REQUIRE(odometry.track(frameAt(0), motion).isOk());
  REQUIRE(odometry.track(frameAt(1), motion = Motion{}).isOk());
  CHECK(motion.v == Approx(20));
}

TEST_CASE("each broken contract has its own message with plugin, call and frame") {
  CHECK(drive("throws_in_configure").message() ==
        "odometry (throws_in_configure), configure: threw: configure gives up");
  CHECK(drive("fails_in_configure").message() ==
        "odometry (fails_in_configure), configure: speed and direction exclude each other; give "
        "one");
  CHECK(drive("fails_in_configure").code() == StatusCode::InvalidParameter);
  CHECK(drive("throws_in_track").message() ==
        "odometry (throws_in_track), track, frame 3: threw: track gives up");
  CHECK(
      drive("throws_an_integer").message() ==
      "odometry (throws_an_integer), track, frame 3: threw something that is not a std::exception");
  CHECK(drive("returns_nan").message() ==
        "odometry (returns_nan), track, frame 3: the answer has NaN, infinity or an illegal "
        "value in 'T_previous_current'");
  CHECK(drive("goes_back_in_time").message() ==
        "odometry (goes_back_in_time), track, frame 3: answered with time -700000000 ns instead of "
        "300000000 ns; copy `stamp_ns` from the input");
  CHECK(drive("answers_another_frame").message() ==
        "odometry (answers_another_frame), track, frame 3: answered for frame 2; copy `frame` from "
        "the input");
  CHECK(drive("revises_the_future").message() ==
        "odometry (revises_the_future), track, frame 3: revised frame 7, which is not a past "
        "frame");
}

TEST_CASE("a finish that throws is contained") {
  OdometryStage odometry(instanceOf("misbehaving", "throws_in_finish"));
  std::vector<MotionRevision> revisions;
  CHECK(odometry.finish(revisions).message() ==
        "odometry (throws_in_finish), finish: threw: finish gives up");
}

namespace {

/// Cells with the answers that the test sets.
struct Puppet : Cells, ArraySource {
  using Parameters = NoParameters;
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status step(const Motion& motion, const PlaceObservation&, Decision& decision) override {
    decision = says;
    decision.frame = motion.frame;
    return Status::ok();
  }
  void arrays(std::vector<NamedArray>& arrays) const override { arrays = shows; }
  static inline thread_local Decision says;
  static inline thread_local std::vector<NamedArray> shows;
};

struct PuppetStage {
  PuppetStage() : stage(create()) {}
  static std::unique_ptr<Instance> create() {
    static constexpr PluginDescriptor kDescriptor = {0,
                                                     1,
                                                     "puppet",
                                                     Role::Cells,
                                                     0,
                                                     &schemaOf<NoParameters>,
                                                     &detail::createPlugin<Puppet>,
                                                     [](Plugin* plugin) { delete plugin; }};
    LoadedPlugin loaded;
    loaded.manifest.id = "puppet";
    loaded.descriptor = &kDescriptor;
    return Instance::create(loaded, "cells");
  }
  std::string say(Action action, std::int64_t experience, double heading = 0, double confidence = 1,
                  std::vector<EarlierLoop> earlier = {}) {
    Puppet::says = {};
    Puppet::says.earlier = std::move(earlier);
    Puppet::says.action = action;
    Puppet::says.experience = experience;
    Puppet::says.heading = heading;
    Puppet::says.confidence = confidence;
    Motion motion;
    motion.frame = frame++;
    Decision decision;
    const std::string message = stage.step(motion, {}, decision).message();
    return message.empty() ? message : message.substr(message.rfind(": ") + 2);
  }
  std::string show(const std::vector<NamedArray>& arrays) {
    Puppet::shows = arrays;
    std::vector<NamedArray> seen;
    const std::string message = stage.instance().arrays(0, seen).message();
    return message.empty() ? message : message.substr(message.rfind(": ") + 2);
  }
  CellsStage stage;
  std::int64_t frame = 0;
};

}  // namespace

TEST_CASE("decisions of cells are checked before the map sees them") {
  PuppetStage cells;
  CHECK(cells.say(Action::Stay, -1).empty());
  CHECK(cells.say(Action::CloseLoop, 0) == "decided for experience 0, which does not exist");
  CHECK(cells.say(Action::CreateExperience, 1) ==
        "created experience 1; ids are 0, 1, 2, ... without gaps, the next one is 0");
  CHECK(cells.say(Action::CreateExperience, 0).empty());
  CHECK(cells.say(Action::CloseLoop, 0).empty());
  CHECK(cells.say(Action::Stay, 1) == "decided for experience 1, which does not exist");
  CHECK(cells.say(Action::Stay, 0, -7) == "heading -7.000000 is not in [0, 2 pi)");
  CHECK(cells.say(Action::Stay, 0, 2 * std::numbers::pi) ==
        "heading is 2 pi, which is not in [0, 2 pi); answer 0");
  CHECK(cells.say(Action::Stay, 0, 0, 42) == "confidence 42.000000 is not in [0, 1]");
}

TEST_CASE("loops of earlier frames name a past frame and a known experience") {
  PuppetStage cells;
  const auto tell = [&](std::int64_t frame, std::int64_t experience) {
    const EarlierLoop loop{frame, experience, Eigen::Isometry3d::Identity(), Matrix6d::Identity()};
    return cells.say(Action::Stay, 0, 0, 1, {loop});
  };
  REQUIRE(cells.say(Action::CreateExperience, 0).empty());
  CHECK(tell(0, 0).empty());
  CHECK(tell(2, 0) == "answered a loop of frame 2, which is not an earlier frame");
  CHECK(tell(-1, 0) == "answered a loop of frame -1, which is not an earlier frame");
  CHECK(tell(1, 1) == "answered a loop of frame 1 to experience 1, which does not exist");
  EarlierLoop wrong;
  wrong.frame = wrong.experience = 0;
  wrong.covariance(2, 2) = std::nan("");
  CHECK(cells.say(Action::Stay, 0, 0, 1, {wrong}) ==
        "the answer has NaN, infinity or an illegal value in 'earlier.covariance'");
}

TEST_CASE("arrays are checked, with the call and the frame in the message") {
  PuppetStage cells;
  CHECK(cells.show({{"a", {2}, {1, 2}}}).empty());
  Puppet::shows = {{"a", {1}, {1}}};
  std::vector<NamedArray> seen;
  CHECK(cells.stage.instance().arrays(7, seen).message() ==
        "cells (puppet), arrays, frame 7: array 'a' changed its shape");
}

namespace {

/// Place recognition with the answers that the test sets, or a failure.
struct PlacePuppet : Place {
  using Parameters = NoParameters;
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  PlaceInput input() const override { return PlaceInput::Frame; }
  Status observe(const Frame& frame, const Motion*, PlaceObservation& answer) override {
    answer = says;
    answer.frame = frame.frame;
    answer.stamp_ns = frame.stamp_ns;
    return Status::ok();
  }
  static inline thread_local PlaceObservation says;
};

struct SourcePuppet : Source {
  using Parameters = NoParameters;
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status info(SourceInfo& info) override {
    info.has_truth = tells_truth;
    return Status::ok();
  }
  Status next(Frame& frame) override {
    frame = frameAt(0);
    frame.has_truth = gives_truth;
    return Status::ok();
  }
  static inline thread_local bool tells_truth = false;
  static inline thread_local bool gives_truth = false;
};

template <class Puppet>
std::unique_ptr<Instance> puppetOf(Role role) {
  static const PluginDescriptor descriptor = {0,
                                              1,
                                              "puppet",
                                              role,
                                              0,
                                              &schemaOf<NoParameters>,
                                              &detail::createPlugin<Puppet>,
                                              [](Plugin* plugin) { delete plugin; }};
  LoadedPlugin loaded;
  loaded.manifest.id = "puppet";
  loaded.descriptor = &descriptor;
  return Instance::create(loaded, "puppet");
}

}  // namespace

TEST_CASE("a turn in degrees is refused where it is read") {
  PlaceStage place(puppetOf<PlacePuppet>(Role::Place));
  PlacePuppet::says = {};
  PlacePuppet::says.recognition = Recognition::Novel;
  PlacePuppet::says.template_id = 0;
  PlacePuppet::says.relative_yaw = 100;
  PlaceObservation seen;
  CHECK(place.observe(frameAt(0), nullptr, seen).isOk());
  PlacePuppet::says.recognition = Recognition::Familiar;
  CHECK_THAT(
      place.observe(frameAt(1), nullptr, seen).message(),
      Catch::EndsWith("relative_yaw 100 is not in [-2 pi, 2 pi]; it is in rad, not degrees"));
  PlacePuppet::says.relative_yaw = -3;
  CHECK(place.observe(frameAt(2), nullptr, seen).isOk());
}

TEST_CASE("a true pose that info() did not announce is refused, a missing one is not") {
  const auto given = [](bool tells, bool gives) {
    SourcePuppet::tells_truth = tells;
    SourcePuppet::gives_truth = gives;
    SourceStage source(puppetOf<SourcePuppet>(Role::Source));
    SourceInfo info;
    REQUIRE(source.info(info).isOk());
    Frame frame;
    return source.next(frame).message();
  };
  CHECK(given(true, true).empty());
  CHECK(given(true, false).empty());  // the path may be known for a part of the way
  CHECK(given(false, true) ==
        "puppet (puppet), next, frame 0: gave a true pose, but info() says that there are none; "
        "set has_truth in both, or in none");
}
