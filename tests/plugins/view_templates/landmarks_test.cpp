// SPDX-License-Identifier: BSD-3-Clause
// Landmarks against scenes whose geometry is known.
#include <catch2/catch.hpp>
#include <sstream>

#include "harness.hpp"
#include "landmark_pose.hpp"
#include "tolman/image_cv.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

const Pinhole kPinhole = {400, 400, 319.5, 119.5};

double texture(double x, double y) {
  return 120 + 30 * std::sin(0.45 * x + 0.2 * y) + 25 * std::sin(0.23 * x - 0.5 * y) +
         20 * std::sin(0.013 * x * x / 3 + 0.3 * y);
}

/// Landmarks 4 to 40 m ahead, seen from `T_template_current` with `noise` px; the last `wrong` of
/// them somewhere else.
std::vector<LandmarkMatch> matches(RandomStream& random,
                                   const Eigen::Isometry3d& T_template_current, int count,
                                   double noise, int wrong) {
  std::vector<LandmarkMatch> result;
  while (static_cast<int>(result.size()) < count) {
    const double z = random.uniform(4, 40);
    const Eigen::Vector3d p(random.uniform(-0.7, 0.7) * z, random.uniform(-0.2, 0.2) * z, z);
    const Eigen::Vector3d q = T_template_current.inverse() * p;
    if (q.z() < 1) continue;
    Eigen::Vector2d pixel = kPinhole.project(q);
    pixel += noise * Eigen::Vector2d(random.normal(), random.normal());
    if (static_cast<int>(result.size()) >= count - wrong) {
      pixel = {random.uniform(0, 640), random.uniform(0, 240)};
    }
    const Eigen::Vector3f point = p.cast<float>();
    result.push_back({{point.x(), point.y(), point.z()},
                      {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())}});
  }
  return result;
}

Eigen::Isometry3d somewhere(RandomStream& random) {
  Vector6d twist;
  twist << random.uniform(-1, 1), random.uniform(-0.2, 0.2), random.uniform(-3, 3),
      random.uniform(-0.03, 0.03), random.uniform(-0.2, 0.2), random.uniform(-0.03, 0.03);
  return expSe3(twist);
}

/// Stereo pairs of the town, at half of KITTI's size.
std::vector<Frame> townFrames(std::int64_t first, std::int64_t last, CameraRig& rig) {
  tolman::test::TestContext context({{"scale", 0.5}, {"first", first}, {"last", last}});
  town::TownSource source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  rig = info.rig;
  std::vector<Frame> frames;
  for (Frame frame; source.next(frame).isOk(); frame = {}) frames.push_back(frame);
  return frames;
}

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

TEST_CASE("disparity is found to a tenth of a pixel, and refused where nothing is alike") {
  const Image left = gray(200, 60, [](int x, int y) { return texture(x, y); });
  for (const double disparity : {3.0, 7.4, 21.75}) {
    const Image right = gray(200, 60, [&](int x, int y) { return texture(x + disparity, y); });
    for (const float x : {60.0F, 101.0F, 150.0F}) {
      CHECK(disparityAt(asMat(left), asMat(right), {x, 30}, 40) == Approx(disparity).margin(0.15));
    }
    CHECK(disparityAt(asMat(left), asMat(right), {100, 2}, 40) < 0);  // too near to the border
  }
  RandomStream random(4);
  CHECK(disparityAt(asMat(left), asMat(noise(200, 60, random)), {100, 30}, 40) < 0);
  const auto fence = [](int x, int) { return x % 8 < 3 ? 200 : 60; };
  CHECK(disparityAt(asMat(gray(200, 60, fence)), asMat(gray(200, 60, fence)), {100, 30}, 40) < 0);
}

TEST_CASE("the pose is that of the majority, and its covariance tells the errors") {
  RandomStream random(8);
  double normalised_errors = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Isometry3d truth = somewhere(random);
    const auto measured = poseOf(matches(random, truth, 120, 0.7, 40), kPinhole, 20);
    REQUIRE(measured);
    const Vector6d error = logSe3(measured->T_template_current.inverse() * truth);
    CHECK(error.head<3>().norm() < 0.15);
    CHECK(error.tail<3>().norm() < 0.01);
    CHECK(measured->inliers >= 78);
    CHECK(measured->inliers <= 90);
    normalised_errors += error.dot(measured->covariance.ldlt().solve(error));
  }
  // Six degrees of freedom, noise 0.7 of the claimed pixel: 6 * 0.49 on average.
  CHECK(normalised_errors / kTrials == Approx(2.9).epsilon(0.35));
}

TEST_CASE("without noise the pose is exact; too few or contradicting matches give none") {
  RandomStream random(9);
  const Eigen::Isometry3d truth = somewhere(random);
  const auto exact = poseOf(matches(random, truth, 50, 0, 0), kPinhole, 20);
  REQUIRE(exact);
  CHECK(exact->T_template_current.isApprox(truth, 1e-4));
  CHECK_FALSE(poseOf(matches(random, truth, 19, 0, 0), kPinhole, 20));
  CHECK_FALSE(poseOf(matches(random, truth, 100, 0, 95), kPinhole, 20));
  CHECK_FALSE(poseOf({}, kPinhole, 20));
}

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
