// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "evaluation/association.hpp"
#include "evaluation/errors.hpp"
#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

double rmse(const Matches& matches, const Similarity& similarity) {
  return absoluteError(aligned(matches, similarity)).rmse;
}

}  // namespace

TEST_CASE("a known rigid motion is recovered") {
  RandomStream random(11);
  for (int round = 0; round < 30; ++round) {
    const Trajectory truth = test::wanderingPath(40, random);
    const Eigen::Isometry3d T = test::randomPose(random);
    const Matches matches = test::paired(truth, test::moved(truth, T));
    const Similarity found = align(matches, Alignment::Se3).value();
    CHECK((found.R - T.linear().transpose()).norm() < 1e-9);
    CHECK((found.t - T.inverse().translation()).norm() < 1e-8);
    CHECK(found.scale == 1);
    CHECK(rmse(matches, found) < 1e-8);
  }
}

TEST_CASE("a known scale is recovered by Sim(3) and by nothing else") {
  RandomStream random(12);
  const Trajectory truth = test::wanderingPath(40, random);
  const Matches matches = test::paired(truth, test::moved(truth, test::randomPose(random), 0.25));
  const Similarity found = align(matches, Alignment::Sim3).value();
  CHECK(found.scale == Approx(4).epsilon(1e-10));
  CHECK(rmse(matches, found) < 1e-8);
  CHECK(rmse(matches, align(matches, Alignment::Se3).value()) > 1);
}

TEST_CASE("the alignment is a minimum: no small motion about it does better") {
  RandomStream random(13);
  const Trajectory truth = test::wanderingPath(30, random);
  Trajectory estimate = test::moved(truth, test::randomPose(random), 1.1);
  for (auto& pose : estimate) {
    for (int i = 0; i < 3; ++i) pose.T_world_camera.translation()[i] += random.normal();
  }
  const Matches matches = test::paired(truth, estimate);
  for (const Alignment kind : {Alignment::Se3, Alignment::Sim3}) {
    const Similarity best = align(matches, kind).value();
    for (int round = 0; round < 100; ++round) {
      Similarity other = best;
      Eigen::Vector3d turn;
      for (int i = 0; i < 3; ++i) turn[i] = 1e-3 * random.normal();
      other.R = expSo3(turn) * best.R;
      for (int i = 0; i < 3; ++i) other.t[i] += 1e-2 * random.normal();
      if (kind == Alignment::Sim3) other.scale *= 1 + 1e-3 * random.normal();
      CHECK(rmse(matches, other) >= rmse(matches, best));
    }
  }
}

TEST_CASE("SE(2) turns about the vertical and leaves height alone") {
  RandomStream random(14);
  const Trajectory truth = test::wanderingPath(40, random);
  const Eigen::Isometry3d T = fromPlanar({3, -2, 0.7});
  Trajectory estimate = test::moved(truth, T.inverse());
  for (auto& pose : estimate) pose.T_world_camera.translation().y() += 5;  // height is wrong
  const Matches matches = test::paired(truth, estimate);
  const Similarity found = align(matches, Alignment::Se2).value();
  CHECK((found.R - T.linear()).norm() < 1e-9);
  CHECK((found.t - T.translation()).norm() < 1e-8);
  const Matches result = aligned(matches, found);
  CHECK(absoluteError(result, Direction::Horizontal).max < 1e-8);
  CHECK(absoluteError(result).min == Approx(5));
}

TEST_CASE("no alignment means none") {
  RandomStream random(15);
  const Trajectory truth = test::straightPath(5);
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().x() = 2;
  const Matches matches = test::paired(truth, test::moved(truth, T));
  CHECK(rmse(matches, align(matches, Alignment::None).value()) == Approx(2));
}

TEST_CASE("degenerate paths give proper rotations: one pose, standing still, a straight line") {
  RandomStream random(16);
  Trajectory standing = test::straightPath(5, 0);
  for (const Trajectory& truth :
       {test::straightPath(1), standing, test::straightPath(2), test::straightPath(60)}) {
    for (int round = 0; round < 20; ++round) {
      const Matches matches = test::paired(truth, test::moved(truth, test::randomPose(random)));
      for (const Alignment kind : {Alignment::Se2, Alignment::Se3}) {
        const Similarity found = align(matches, kind).value();
        CHECK(found.R.determinant() == Approx(1).epsilon(1e-9));
        CHECK((found.R * found.R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-9);
        if (kind == Alignment::Se3) CHECK(rmse(matches, found) < 1e-7);
      }
    }
  }
}

TEST_CASE("a line driven the other way is turned round, not mirrored") {
  const Trajectory truth = test::straightPath(10);
  Trajectory estimate = truth;
  for (auto& pose : estimate) pose.T_world_camera.translation() *= -1;
  const Matches matches = test::paired(truth, estimate);
  const Similarity found = align(matches, Alignment::Se3).value();
  CHECK(found.R.determinant() == Approx(1));
  CHECK(rmse(matches, found) < 1e-9);
}

TEST_CASE("a mirrored path cannot be aligned, and no reflection is used") {
  RandomStream random(17);
  const Trajectory truth = test::wanderingPath(40, random);
  Trajectory estimate = truth;
  for (auto& pose : estimate) pose.T_world_camera.translation().x() *= -1;
  const Matches matches = test::paired(truth, estimate);
  const Similarity found = align(matches, Alignment::Sim3).value();
  CHECK(found.R.determinant() == Approx(1));
  CHECK(rmse(matches, found) > 0.1);
}

TEST_CASE("Sim(3) refuses where there is no scale") {
  const Trajectory still = test::straightPath(5, 0);
  const Trajectory moving = test::straightPath(5);
  for (const Matches& matches : {test::paired(still, moving), test::paired(moving, still)}) {
    CHECK(align(matches, Alignment::Sim3).status().message() ==
          "no scale can be found: truth or estimate does not move");
  }
}
