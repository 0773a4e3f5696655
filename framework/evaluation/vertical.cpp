// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/vertical.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "evaluation/trajectory.hpp"

namespace tolman::evaluation {
namespace {

using Points = Eigen::Matrix3Xd;

constexpr double kRounding = 1e-12;  // share of the path's extent below which errors are rounding
constexpr double kSameError = 1.05;
constexpr double kMovedShare = 0.1;  // of the squared error
// Between the alignment and the orientations: a sixth of the vertical error then counts as
// horizontal. Chosen on the clip of KITTI 06: two estimates of 250 and 281 frames had 7 and 8
// degrees.
constexpr double kTilted = 10 * std::numbers::pi / 180;
// Of the true path: such an error is that of an ordinary estimate. Chosen, not tuned.
constexpr double kOrdinary = 0.01;
// Two drifts, such as one in height and one to the side, have a correlation of 0.94 and more by
// chance where an alignment reduces the error to a third by one turn. Reasoned, not tuned.
constexpr double kChance = 3;

/// Sums of squared errors after a turn of the estimate about its mean.
struct SquaredError {
  double all;
  double vertical;
};

SquaredError errorAfter(const Points& truth, const Points& estimate, const Eigen::Matrix3d& turn) {
  const Points error = truth - turn * estimate;
  return {error.squaredNorm(), error.row(1).squaredNorm()};
}

bool isOpenAbout(const Eigen::Vector3d& axis, const Points& truth, const Points& estimate) {
  const SquaredError now = errorAfter(truth, estimate, Eigen::Matrix3d::Identity());
  bool quarter_is_free = false;
  bool moves = false;
  for (int eighths = 1; eighths < 8; ++eighths) {
    const double angle = eighths * std::numbers::pi / 4;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const SquaredError turned = errorAfter(truth, estimate, turn);
    const bool quarter = eighths == 2 || eighths == 6;
    if (quarter && turned.all < kSameError * kSameError * now.all) quarter_is_free = true;
    if (std::abs(turned.vertical - now.vertical) > kMovedShare * now.all) moves = true;
  }
  return quarter_is_free && moves;
}

/// The rotation, about any axis, that brings the estimated orientations nearest to the true ones.
Eigen::Matrix3d turnToOrientations(const Matches& aligned) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < aligned.truth.size(); ++i) {
    sum += aligned.truth[i].T_world_camera.linear() *
           aligned.estimate[i].T_world_camera.linear().transpose();
  }
  return Eigen::Affine3d(sum).rotation();
}

/// The part of a rotation that is about `axis`.
Eigen::Matrix3d twist(const Eigen::Matrix3d& turn, const Eigen::Vector3d& axis) {
  const Eigen::Quaterniond q(turn);
  const double angle = 2 * std::atan2(q.vec().dot(axis), q.w());
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

Eigen::Matrix3d principalDirections(const Points& points) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(points * points.transpose()).eigenvectors();
}

}  // namespace

std::string upAxisProblem(const Trajectory& truth) {
  constexpr double kAlongX = 0.9;  // of the path; chosen, not tuned
  constexpr double kMoreY = 2;     // extent along y over that along z; chosen, not tuned
  if (truth.empty()) return "";
  double length = 0, along_x = 0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Eigen::Vector3d step =
        (truth[i - 1].T_world_camera.inverse() * truth[i].T_world_camera).translation();
    length += step.norm();
    along_x += std::fabs(step.x());
  }
  const Eigen::Vector3d size = extentFromFirst(truth);
  if (!(along_x > kAlongX * length) || !(size.y() > kMoreY * size.z())) return "";
  return fmt::format(
      "the true poses move along their own x axis, and more along the y axis of the first one "
      "({:.3g} m) than along its z axis ({:.3g} m), as poses with x forward and z up do, and y is "
      "taken as down: give poses of the camera (x right, y down, z forward)",
      size.y(), size.z());
}

std::string planeProblem(const Trajectory& truth) {
  constexpr double kSteepest = 0.5;  // steeper than any road; ramps of car parks have 0.2
  const Eigen::Vector3d size = extentFromFirst(truth);
  const double width = std::hypot(size.x(), size.z());
  if (size.y() <= kSteepest * width) return "";
  return fmt::format(
      "se2 compares on the x-z plane of the first true pose (camera axes: x right, y down, z "
      "forward), but the truth moves {:.3g} m along that pose's y axis and only {:.3g} m in the "
      "plane; use se3, or give the truth as poses of a level camera",
      size.y(), width);
}

bool rollIsUnobservable(const Matches& aligned) {
  const Points truth = centredPositions(aligned.truth);
  const Points estimate = centredPositions(aligned.estimate);
  if ((truth - estimate).norm() <= kRounding * truth.norm()) return false;
  const Eigen::Matrix3d directions = principalDirections(truth);
  for (int i = 0; i < 3; ++i) {
    if (isOpenAbout(directions.col(i), truth, estimate)) return true;
  }
  return false;
}

bool rollIsContradicted(const Matches& aligned) {
  const Points truth = centredPositions(aligned.truth);
  const Points estimate = centredPositions(aligned.estimate);
  const auto rmseAfter = [&](const Eigen::Matrix3d& turn) {
    return std::sqrt(errorAfter(truth, estimate, turn).all / static_cast<double>(truth.cols()));
  };
  const Eigen::Matrix3d directions = principalDirections(truth);
  const Eigen::Matrix3d whole = turnToOrientations(aligned);
  const std::array turns{whole, twist(whole, directions.col(0)), twist(whole, directions.col(1)),
                         twist(whole, directions.col(2))};
  const double accepted = std::max(kChance * rmseAfter(Eigen::Matrix3d::Identity()),
                                   kOrdinary * pathLength(aligned.truth));
  return std::ranges::any_of(turns, [&](const Eigen::Matrix3d& turn) {
    return turn(1, 1) < std::cos(kTilted) && rmseAfter(turn) <= accepted;
  });
}

}  // namespace tolman::evaluation
