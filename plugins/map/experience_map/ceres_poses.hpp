// SPDX-License-Identifier: BSD-3-Clause
// Poses as parameter blocks of Ceres, on a manifold.
#pragma once

#include <ceres/manifold.h>

#include <array>

#include "pose_link.hpp"

namespace tolman::experience_map {

template <class G>
struct CeresPose;

template <int kRows, int kColumns>
using RowMatrix = Eigen::Matrix<double, kRows, kColumns, Eigen::RowMajor>;

/// (x m, y m, theta rad). theta stays in [-pi, pi), the constraint of the paper's problem.
template <>
struct CeresPose<Plane> {
  static constexpr int kSize = 3;
  using Block = std::array<double, kSize>;

  static PlanarPose poseOf(const double* block) { return {block[0], block[1], block[2]}; }
  static Block blockOf(const PlanarPose& pose) { return {pose.x, pose.y, pose.theta}; }
  /// Derivative of the step with respect to the block.
  static RowMatrix<3, 3> stepByBlock(const double*) { return RowMatrix<3, 3>::Identity(); }
  /// Derivative of the block with respect to the step, at the zero step.
  static RowMatrix<3, 3> blockByStep(const double*) { return RowMatrix<3, 3>::Identity(); }
  static Eigen::Vector3d between(const PlanarPose& from, const PlanarPose& to) {
    return {to.x - from.x, to.y - from.y, wrapAngle(to.theta - from.theta)};
  }
};

/// Translation (m) and unit quaternion (x, y, z, w).
template <>
struct CeresPose<Space> {
  static constexpr int kSize = 7;
  using Block = std::array<double, kSize>;

  static Eigen::Quaterniond quaternionOf(const double* block) {
    return Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(block + 3));
  }
  static Eigen::Isometry3d poseOf(const double* block) {
    Eigen::Isometry3d T(quaternionOf(block).normalized());
    T.translation() = Eigen::Map<const Eigen::Vector3d>(block);
    return T;
  }
  static Block blockOf(const Eigen::Isometry3d& pose) {
    Block block;
    Eigen::Map<Eigen::Vector3d>(block.data()) = pose.translation();
    Eigen::Map<Eigen::Vector4d>(block.data() + 3) =
        Eigen::Quaterniond(pose.linear()).normalized().coeffs();
    return block;
  }
  static RowMatrix<6, 7> stepByBlock(const double* block) {
    const Eigen::Quaterniond q = quaternionOf(block);
    RowMatrix<6, 7> by = RowMatrix<6, 7>::Zero();
    by.topLeftCorner<3, 3>() = q.toRotationMatrix().transpose();
    by.block<3, 3>(3, 3) = 2 * (q.w() * Eigen::Matrix3d::Identity() - skew(q.vec()));
    by.block<3, 1>(3, 6) = -2 * q.vec();
    return by;
  }
  static RowMatrix<7, 6> blockByStep(const double* block) {
    const Eigen::Quaterniond q = quaternionOf(block);
    RowMatrix<7, 6> by = RowMatrix<7, 6>::Zero();
    by.topLeftCorner<3, 3>() = q.toRotationMatrix();
    by.block<3, 3>(3, 3) = 0.5 * (q.w() * Eigen::Matrix3d::Identity() + skew(q.vec()));
    by.block<1, 3>(6, 3) = -0.5 * q.vec().transpose();
    return by;
  }
  static Vector6d between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
    return logSe3(from.inverse() * to);
  }
};

}  // namespace tolman::experience_map
