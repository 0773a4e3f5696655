// SPDX-License-Identifier: BSD-3-Clause
#include "level_step.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace tolman::bayesian_attractor {
namespace {

/// The smallest rotation that makes the camera level.
Eigen::Matrix3d levelling(const Eigen::Vector3d& up) {
  return Eigen::Quaterniond::FromTwoVectors(up, kLevelUp).toRotationMatrix();
}

/// Covariance of (forward, left, heading): the camera's z and -x, and the rotation about -y.
/// Correlations are dropped.
Eigen::Matrix3d planarVariance(const Matrix6d& covariance) {
  return Eigen::Vector3d(covariance(2, 2), covariance(0, 0), covariance(4, 4)).asDiagonal();
}

}  // namespace

LevelStep levelStep(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance,
                    const Eigen::Vector3d& up_from) {
  LevelStep step;
  step.up = (T_from_to.linear().transpose() * up_from).normalized();
  const Eigen::Matrix3d R_level_to = levelling(step.up);
  const Eigen::Isometry3d T_level =
      Eigen::Isometry3d(levelling(up_from)) * T_from_to * Eigen::Isometry3d(R_level_to.transpose());
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_level_to;
  const Matrix6d level_covariance = turn * covariance * turn.transpose();
  step.plane = toPlanar(T_level);
  step.covariance = planarVariance(level_covariance);
  step.climb = {-T_level.translation().y(), level_covariance(1, 1)};
  return step;
}

LevelStep planarStep(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance) {
  return {toPlanar(T_from_to), planarVariance(covariance), {}, kLevelUp};
}

namespace {

// All chosen, not tuned.
constexpr double kWholeTurn = 0.25;  // rad; smaller turns, of shaking and ramps, are not added
constexpr double kOneWay = 0.9;      // least ratio of the length of the sum of steps to the path
constexpr double kMinTurns = 0.12;   // rad^2; about two turns of kWholeTurn
constexpr double kOneAxis = 4;       // least ratio of turns about one axis to those about the other

/// Product of two rotations, orthonormal again after rounding.
Eigen::Matrix3d composed(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::Quaterniond(a * b).normalized().toRotationMatrix();
}

}  // namespace

void Upright::add(const Eigen::Isometry3d& T_previous_current) {
  const Eigen::Vector3d step = T_previous_current.translation();
  path += step.norm();
  forward += step.dot(forward) < 0 ? Eigen::Vector3d(-step) : step;
  R_first_camera = composed(R_first_camera, T_previous_current.linear());
  R_turn_camera = composed(R_turn_camera, T_previous_current.linear());
  const Eigen::Vector3d turn = logSo3(R_turn_camera);
  if (turn.norm() < kWholeTurn) return;
  turns += turn * turn.transpose();
  R_turn_camera.setIdentity();
}

bool Upright::isVehicle() const { return path >= 1 && forward.norm() >= kOneWay * path; }

Eigen::Vector3d Upright::upOfVehicle() const {
  if (!isVehicle()) return kLevelUp;
  const Eigen::Vector3d ahead = forward.normalized();
  const Eigen::Vector3d assumed = kLevelUp - ahead * ahead.dot(kLevelUp);
  if (assumed.norm() < 1e-3) return kLevelUp;  // forward is vertical, up to 1e-3 rad
  const Eigen::Vector3d up = assumed.normalized();
  // Turns about the two axes perpendicular to forward: yaw about one, pitch of ramps about the
  // other one.
  Eigen::Matrix<double, 3, 2> across;
  across << up, ahead.cross(up);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> turned(across.transpose() * turns * across);
  const Eigen::Vector2d& amount = turned.eigenvalues();  // ascending
  if (amount[1] < kMinTurns || amount[1] < kOneAxis * amount[0]) return up;
  const Eigen::Vector3d axis = across * turned.eigenvectors().col(1);
  return axis.dot(up) < 0 ? Eigen::Vector3d(-axis) : axis;
}

}  // namespace tolman::bayesian_attractor
