// SPDX-License-Identifier: BSD-3-Clause
// Templates with landmarks, in the town.
#include <catch2/catch.hpp>
#include <sstream>

#include "harness.hpp"
#include "support/town_frames.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;
using tolman::test::townFrames;

namespace {

const ParameterValues kMeasuring = {{"landmarks", std::int64_t{400}}, {"threshold", 0.3}};

Status configureWith(ViewTemplates& plugin, const CameraRig& rig, const ParameterValues& values) {
  tolman::test::TestContext services(values);
  services.rig = rig;
  return plugin.configure(services);
}

PlaceObservation observeFrame(ViewTemplates& plugin, const Frame& frame) {
  PlaceObservation observation;
  const Status status = plugin.observe(frame, nullptr, observation);
  INFO(status.message());
  REQUIRE(status.isOk());
  return observation;
}

}  // namespace

TEST_CASE("town: a place seen again from 3 m further on is measured to a decimetre") {
  CameraRig rig;
  const std::vector<Frame> frames = townFrames(40, 46, rig);
  ViewTemplates plugin;
  REQUIRE(configureWith(plugin, rig, kMeasuring).isOk());
  CHECK(observeFrame(plugin, frames.front()).recognition == Recognition::Novel);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const PlaceObservation seen = observeFrame(plugin, frames[i]);
    if (seen.template_id != 0) continue;
    REQUIRE(seen.has_relative_pose);
    const Eigen::Isometry3d expected =
        frames.front().T_world_camera_truth.inverse() * frames[i].T_world_camera_truth;
    const Vector6d error = logSe3(seen.T_template_current.inverse() * expected);
    INFO("after " << expected.translation().norm() << " m: " << error.transpose());
    CHECK(error.head<3>().norm() < 0.1 + 0.03 * expected.translation().norm());
    CHECK(error.tail<3>().norm() < 0.01);
    CHECK(seen.relative_yaw == Approx(toPlanar(expected).theta).margin(0.01));
  }
}

TEST_CASE("town: what looks alike but has other landmarks is a place of its own") {
  CameraRig rig;
  const std::vector<Frame> here = townFrames(40, 40, rig);
  const std::vector<Frame> there = townFrames(90, 90, rig);
  ViewTemplates trusting;
  ViewTemplates checking;
  ParameterValues values = {{"threshold", 0.9}};  // everything looks like everything
  REQUIRE(configureWith(trusting, rig, values).isOk());
  values["landmarks"] = std::int64_t{400};
  REQUIRE(configureWith(checking, rig, values).isOk());
  observeFrame(trusting, here.front());
  observeFrame(checking, here.front());
  CHECK(observeFrame(trusting, there.front()).recognition == Recognition::Familiar);
  CHECK(observeFrame(checking, there.front()).recognition == Recognition::Novel);
  CHECK(observeFrame(checking, here.front()).template_id == 0);
}

TEST_CASE("landmarks are saved with their templates; damaged ones are refused") {
  CameraRig rig;
  const std::vector<Frame> frames = townFrames(40, 42, rig);
  ViewTemplates saved;
  ViewTemplates loaded;
  REQUIRE(configureWith(saved, rig, kMeasuring).isOk());
  REQUIRE(configureWith(loaded, rig, kMeasuring).isOk());
  observeFrame(saved, frames[0]);
  std::stringstream stream;
  REQUIRE(saved.save(stream).isOk());
  REQUIRE(loaded.load(stream).isOk());
  const PlaceObservation a = observeFrame(saved, frames[2]);
  const PlaceObservation b = observeFrame(loaded, frames[2]);
  CHECK(a.has_relative_pose);
  CHECK(a.T_template_current.matrix() == b.T_template_current.matrix());
  CHECK(a.covariance == b.covariance);
  ViewTemplates without;
  REQUIRE(configureWith(without, rig, {{"threshold", 0.3}}).isOk());
  std::istringstream again(stream.str());
  CHECK(without.load(again).code() == StatusCode::InvalidInput);
}

TEST_CASE("one camera: no landmarks, and recognition as ever") {
  CameraRig rig;
  std::vector<Frame> frames = townFrames(40, 41, rig);
  for (Frame& frame : frames) frame.right = {};
  rig.baseline = 0;
  tolman::test::TestContext services(kMeasuring);
  services.rig = rig;
  ViewTemplates plugin;
  REQUIRE(plugin.configure(services).isOk());
  REQUIRE(services.log.size() == 1);
  CHECK(services.log.front() ==
        "landmarks need a calibrated stereo pair; views are recognised by appearance alone: set "
        "landmarks to 0 and lower the threshold");
  observeFrame(plugin, frames[0]);
  const PlaceObservation seen = observeFrame(plugin, frames[1]);
  CHECK(seen.recognition == Recognition::Familiar);
  CHECK_FALSE(seen.has_relative_pose);
}
