// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/open_turn.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace tolman::evaluation {
namespace {

using Points = Eigen::Matrix3Xd;

// Root mean square errors below this share of the extent of the path are rounding errors.
constexpr double kRounding = 1e-12;
constexpr double kSameError = 1.05;
constexpr double kMovedShare = 0.1;  // of the squared error

/// Positions relative to their mean.
Points centred(const Trajectory& trajectory) {
  Points points(3, static_cast<Eigen::Index>(trajectory.size()));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = trajectory[i].T_world_camera.translation();
  }
  const Eigen::Vector3d mean = points.rowwise().mean();
  return points.colwise() - mean;
}

/// Sums of squared errors.
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

}  // namespace

bool turnIsOpen(const Matches& aligned) {
  const Points truth = centred(aligned.truth);
  const Points estimate = centred(aligned.estimate);
  if ((truth - estimate).norm() <= kRounding * truth.norm()) return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions(truth * truth.transpose());
  for (int i = 0; i < 3; ++i) {
    if (isOpenAbout(directions.eigenvectors().col(i), truth, estimate)) return true;
  }
  return false;
}

}  // namespace tolman::evaluation
