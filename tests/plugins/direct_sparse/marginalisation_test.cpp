// SPDX-License-Identifier: BSD-3-Clause
// Marginalised points and keyframes have the same effect on the window as if they were kept.
#include <catch2/catch.hpp>
#include <cmath>

#include "bundle_adjustment.hpp"
#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

std::unique_ptr<Window> keyframes(std::size_t count, int points) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t k = 0; k < count; ++k) {
    poses.push_back(test::streetPose(0.6 * static_cast<double>(k), 0.004 * static_cast<double>(k)));
  }
  auto window = test::streetWindow(poses);
  test::addTruePoints(*window, points);
  window->prior.H.diagonal().tail<kFieldVariables>().setConstant(1e4);
  window->keyframe(0).has_prior = true;
  return window;
}

void hostedBy(Window& window, int slot) {
  for (const int other : window.order()) {
    if (other != slot) window.keyframe(other).points.clear();
  }
}

/// Small pose changes, with the world moved along such that keyframe `anchor` stays.
SystemVector asSeenFrom(int anchor, const Window& window, SystemVector changes) {
  const auto moved = [&](int slot) -> Eigen::Isometry3d {
    return expSe3(changes.segment<6>(8 * slot)) * window.keyframe(slot).T0_camera_world;
  };
  const Eigen::Isometry3d world = moved(anchor).inverse() * window.keyframe(anchor).T0_camera_world;
  SystemVector seen = changes;
  for (const int slot : window.order()) {
    seen.segment<6>(8 * slot) =
        logSe3(moved(slot) * world * window.keyframe(slot).T0_camera_world.inverse());
  }
  return seen;
}

}  // namespace

TEST_CASE("solving with a marginalised keyframe equals solving with all variables kept") {
  const CameraRig rig = test::streetRig();
  // Kept: everything in one system.
  const auto kept = keyframes(4, 120);
  LinearSystem whole;
  whole.build(rig, {1.0F}, *kept, allPoints(*kept));
  // What the leaving keyframe sees from others goes with it in the window; leave it out here too.
  for (const int slot : {1, 2, 3}) {
    for (Point& point : kept->keyframe(slot).points) point.temporal[0] = ResidualState::Absent;
  }
  whole.build(rig, {1.0F}, *kept, allPoints(*kept));
  const SystemVector held = solve(*kept, whole.H(), whole.b());  // keyframe 0 stays

  const auto window = keyframes(4, 120);
  for (const int slot : {1, 2, 3}) {
    for (Point& point : window->keyframe(slot).points) point.temporal[0] = ResidualState::Absent;
  }
  LinearSystem system;
  system.build(rig, {1.0F}, *window, allPoints(*window));
  system.storeInformation(*window);
  for (Point& point : window->keyframe(0).points) {
    point.seen_good = 3;  // all worth keeping, as in the whole system
    point.information = 1e6F;
  }
  marginalisePoints(rig, {1.0F}, {0}, 1.0, *window, system);
  CHECK(window->keyframe(0).points.empty());
  CHECK(window->keyframe(1).has_prior);
  marginaliseKeyframe(0, *window);
  CHECK(window->order() == std::vector<int>{1, 2, 3});
  system.build(rig, {1.0F}, *window, allPoints(*window));
  const SystemVector step = solve(*window, system.H(), system.b());  // keyframe 1 stays
  const SystemVector expected = asSeenFrom(1, *window, held);
  for (const int slot : {1, 2, 3}) {
    CAPTURE(slot, step.segment<8>(8 * slot).transpose(), expected.segment<8>(8 * slot).transpose());
    CHECK((step - expected).segment<6>(8 * slot).norm() <
          0.02 * expected.segment<6>(8 * slot).norm() + 2e-5);
  }
  CHECK(step.head<16>().isZero(0));
}

TEST_CASE("a keyframe's Schur complement is that of the dense prior") {
  Window window;
  window.add();
  window.add();
  Eigen::MatrixXd A = Eigen::MatrixXd::Random(40, 17);
  Eigen::MatrixXd dense = A.transpose() * A;
  Eigen::VectorXd b = Eigen::VectorXd::Random(17);
  window.prior.H.topLeftCorner<16, 16>() = dense.topLeftCorner(16, 16);
  window.prior.H.block<16, 1>(0, kOffsetIndex) = dense.topRightCorner(16, 1);
  window.prior.H.block<1, 16>(kOffsetIndex, 0) = dense.bottomLeftCorner(1, 16);
  window.prior.H(kOffsetIndex, kOffsetIndex) = dense(16, 16);
  window.prior.b.head<16>() = b.head<16>();
  window.prior.b[kOffsetIndex] = b[16];
  marginaliseKeyframe(0, window);
  const Eigen::MatrixXd inverse = dense.topLeftCorner(8, 8).inverse();
  const Eigen::MatrixXd H = dense.bottomRightCorner(9, 9) -
                            dense.bottomLeftCorner(9, 8) * inverse * dense.topRightCorner(8, 9);
  const Eigen::VectorXd g = b.tail(9) - dense.bottomLeftCorner(9, 8) * inverse * b.head(8);
  CHECK(window.prior.H.block<8, 8>(8, 8).isApprox(H.topLeftCorner(8, 8), 1e-6));
  CHECK(window.prior.H(kOffsetIndex, kOffsetIndex) == Approx(H(8, 8)).epsilon(1e-6));
  CHECK(window.prior.b.segment<8>(8).isApprox(g.head(8), 1e-6));
  CHECK(window.prior.H.topLeftCorner<8, 8>().isZero(0));
}

TEST_CASE("the prior is that of the first estimates, wherever the state has gone meanwhile") {
  const CameraRig rig = test::streetRig();
  const auto window = keyframes(3, 80);
  window->keyframe(0).has_prior = window->keyframe(1).has_prior = true;
  window->keyframe(1).change[2] = 0.004;
  hostedBy(*window, 0);
  for (Point& point : window->keyframe(0).points) {
    point.seen_good = 5;
    point.information = 1e6F;
  }
  const SystemVector x = changes(*window);
  LinearSystem system;
  system.build(rig, {1.0F}, *window, allPoints(*window));
  const SystemVector gradient_now = system.b();
  const Prior before = window->prior;
  marginalisePoints(rig, {1.0F}, {0}, 1.0, *window, system);
  const SystemMatrix added = window->prior.H - before.H;
  const SystemVector at_present = window->prior.b - before.b + added * x;
  CHECK((at_present - gradient_now).norm() < 1e-6 * gradient_now.norm() + 1e-6);
}

TEST_CASE("points that the two newest keyframes do not see leave; bad ones leave nothing behind") {
  const CameraRig rig = test::streetRig();
  const auto window = keyframes(4, 60);
  LinearSystem system;
  system.build(rig, {1.0F}, *window, allPoints(*window));
  system.storeInformation(*window);
  std::vector<Point>& points = window->keyframe(0).points;
  const std::size_t before = points.size();
  std::size_t unseen = 0;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    points[i].temporal[2] = points[i].temporal[3] = ResidualState::Outside;
    points[i].information = 1;  // too little to keep
  }
  for (const Point& p : points) {
    const bool seen = p.temporal[2] == ResidualState::Good || p.temporal[3] == ResidualState::Good;
    unseen += seen ? 0 : 1;
    if (!seen) CHECK(p.information <= 1e9F);
  }
  marginalisePoints(rig, {1.0F}, {}, 1.0, *window, system);
  CHECK(points.size() == before - unseen);
  CHECK_FALSE(window->keyframe(3).points.empty());
}

TEST_CASE("keyframes leave: the exhausted, the differently bright, the crowded; never the newest") {
  const auto window = keyframes(5, 40);
  CHECK(chooseLeaving(*window, 5).empty());
  SECTION("hardly any points left") {
    Keyframe& old = window->keyframe(1);
    old.points_made = 400;
    old.points.resize(2);
    CHECK(chooseLeaving(*window, 5) == std::vector<int>{1});
  }
  SECTION("another brightness") {
    window->keyframe(0).affine0.a = 1;
    CHECK(chooseLeaving(*window, 5) == std::vector<int>{0});
  }
  SECTION("too many: the one that stands closest to others") {
    window->keyframe(1).T0_camera_world = test::streetPose(0.1).inverse();
    const std::vector<int> leaving = chooseLeaving(*window, 4);
    REQUIRE(leaving.size() == 1);
    CHECK((leaving[0] == 0 || leaving[0] == 1));
  }
  SECTION("the two newest stay whatever they have") {
    window->keyframe(3).points.clear();
    window->keyframe(4).points.clear();
    window->keyframe(3).points_made = window->keyframe(4).points_made = 1000;
    for (const int slot : chooseLeaving(*window, 3)) CHECK(slot < 3);
  }
}
