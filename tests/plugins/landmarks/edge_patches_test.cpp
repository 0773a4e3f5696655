// SPDX-License-Identifier: BSD-3-Clause
// Patches of edges are found again in other light, where they are seen, and not in other places.
#include "edge_patches.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/gray_images.hpp"
#include "support/street_scene.hpp"
#include "tolman/context.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::landmarks;
using namespace tolman::test;

namespace {

/// As by night: a gamma, a lamp in front of the camera, a sixth of its light at the sides, and
/// noise of two grey levels.
Image byNight(const Image& day, std::uint64_t seed) {
  RandomStream random(seed);
  return gray(day.width(), day.height(), [&](int x, int y) {
    const double level = day.row(y)[x] / 255.0;
    const double side = (x - 0.5 * day.width()) / (0.35 * day.width());
    const double lamp = 0.15 + 0.85 * std::exp(-0.5 * side * side);
    return std::clamp(200 * lamp * std::pow(level, 1.6) + 2 * random.normal(), 0.0, 255.0);
  });
}

/// Landmarks of the street, as seen from its beginning, with their patches.
struct Template {
  CameraRig rig = streetRig();
  Landmarks landmarks;
  std::vector<EdgePatch> patches;

  Template() {
    const Frame frame = streetFrame(0, Eigen::Isometry3d::Identity());
    const cv::Mat left = asMat(frame.left);
    landmarks = findLandmarks(left, asMat(frame.right), rig, findCorners(left, 400));
    const EdgeMap map(left);
    for (const cv::Point3f& p : landmarks.points) {
      patches.push_back(patchAt(map, landmarks::pixelOf(p, rig.pinhole)));
    }
  }
  std::vector<LandmarkMatch> searchedIn(const Image& image) const {
    const EdgeMap map(asMat(image));
    return EdgeSearch(map).find(landmarks.points, patches, rig.pinhole);
  }
};

int rightOnes(const std::vector<LandmarkMatch>& matches, const Pinhole& pinhole,
              const Eigen::Isometry3d& T_template_current) {
  int right = 0;
  for (const LandmarkMatch& match : matches) {
    const Eigen::Vector3d p(match.point.x, match.point.y, match.point.z);
    const Eigen::Vector2d expected = pinhole.project(T_template_current.inverse() * p);
    right += (expected - Eigen::Vector2d(match.pixel.x, match.pixel.y)).norm() < 3 ? 1 : 0;
  }
  return right;
}

}  // namespace

TEST_CASE("in the image of the template each patch is found at its pixel") {
  const Template stored;
  REQUIRE(stored.patches.size() > 50);
  const auto found = stored.searchedIn(streetFrame(0, Eigen::Isometry3d::Identity()).left);
  REQUIRE(found.size() > stored.patches.size() * 8 / 10);  // others are at a border or look alike
  for (const LandmarkMatch& match : found) {
    const cv::Point2f expected = pixelOf(match.point, stored.rig.pinhole);
    CHECK(std::hypot(match.pixel.x - expected.x, match.pixel.y - expected.y) < 0.8);
  }
}

TEST_CASE("by night and from another place a pose is found") {
  const Template stored;
  const Eigen::Isometry3d ahead =
      Eigen::Translation3d(0.3, 0, 0.8) * Eigen::AngleAxisd(0.03, Eigen::Vector3d::UnitY());
  const Image night = byNight(streetFrame(1, ahead).left, 3);
  const auto found = stored.searchedIn(night);
  CHECK(rightOnes(found, stored.rig.pinhole, ahead) > static_cast<int>(0.7 * double(found.size())));
  const EdgeMap map(asMat(night));
  const double sigma = EdgeSearch(map).sigma();
  const auto pose = poseOf(found, stored.rig.pinhole, 40, sigma);
  REQUIRE(pose);
  const Vector6d error = logSe3(pose->T_template_current.inverse() * ahead);
  CHECK(error.head<3>().norm() < 0.15);
  CHECK(error.tail<3>().norm() < 0.01);
}

TEST_CASE("where bright and dark are exchanged corners find no pose, edges do") {
  const Template stored;
  const Eigen::Isometry3d ahead(Eigen::Translation3d(0.1, 0, 0.5));
  const Image negative = changed(streetFrame(1, ahead).left, -0.8, 230);
  const auto corners = findAgain(stored.landmarks, findCorners(asMat(negative), 400));
  CHECK_FALSE(poseOf(corners, stored.rig.pinhole, 20, 1));
  const auto pose = poseOf(stored.searchedIn(negative), stored.rig.pinhole, 40, 1);
  REQUIRE(pose);
  CHECK((pose->T_template_current.translation() - ahead.translation()).norm() < 0.15);
}

TEST_CASE("in noise few patches agree on a pose, and in a blank image none is found") {
  const Template stored;
  RandomStream random(5);
  const auto agreeing = [&](const Image& image) {
    const auto pose = poseOf(stored.searchedIn(image), stored.rig.pinhole, 6, 1.1);
    return pose ? pose->inliers : 0;
  };
  CHECK(agreeing(noise(480, 200, random)) < 20);
  CHECK(stored.searchedIn(filled(90)).empty());
}

TEST_CASE(
    "an image smaller than a window gives no match, and points beside the image are harmless") {
  const Template stored;
  CHECK(stored.searchedIn(gray(20, 10, [](int x, int) { return 8 * x; })).empty());
  const cv::Point3f beside(100, 0, 1);
  const EdgeMap map(asMat(streetFrame(0, Eigen::Isometry3d::Identity()).left));
  const EdgePatch patch = patchAt(map, {-1e6F, 1e6F});
  CHECK(EdgeSearch(map).find({beside}, {patch}, stored.rig.pinhole).size() <= 1);
}
