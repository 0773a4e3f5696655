// SPDX-License-Identifier: BSD-3-Clause
// Angles, rigid motions and the one conversion between camera axes and the plane.
//
// Camera axes: x right, y down, z forward. Planar poses: x forward at the start, y left, theta
// counter-clockwise seen from above, in metres and radians. So x_plane = z, y_plane = -x, and a
// turn to the left is positive.
//
// Functions that use much of Eigen are templates whose parameter is not used. So only files that
// call them compile them; as plain inline functions they triple the compile time of every plugin.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace tolman {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Wraps an angle to [-pi, pi).
inline double wrapAngle(double angle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double wrapped = angle - kTurn * std::floor((angle + std::numbers::pi) / kTurn);
  return wrapped < std::numbers::pi ? wrapped : wrapped - kTurn;  // floor can round up to pi
}

/// Wraps a value to [0, period).
inline double wrapPeriod(double value, double period) {
  const double wrapped = value - period * std::floor(value / period);
  return wrapped < period ? wrapped : 0.0;
}

/// The cross-product matrix: skew(a) * b == a x b.
template <class = void>
Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// Rotation vector (axis times angle, rad) to rotation matrix.
template <class = void>
Eigen::Matrix3d expSo3(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle < 1e-10) return Eigen::Matrix3d::Identity() + skew(rotation);
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

/// Rotation matrix to rotation vector, angle in [0, pi].
template <class = void>
Eigen::Vector3d logSo3(const Eigen::Matrix3d& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-10) return 2.0 * q.vec();
  return (2.0 * std::atan2(sine, q.w()) / sine) * q.vec();
}

/// Matrix V of the SE(3) exponential: translation = V(rotation) * rho.
template <class = void>
Eigen::Matrix3d leftJacobianSo3(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  const Eigen::Matrix3d W = skew(rotation);
  if (angle < 1e-5) return Eigen::Matrix3d::Identity() + 0.5 * W + W * W / 6.0;
  const double a2 = angle * angle;
  return Eigen::Matrix3d::Identity() + (1 - std::cos(angle)) / a2 * W +
         (angle - std::sin(angle)) / (a2 * angle) * W * W;
}

/// Twist (rho, rotation) to rigid motion. The order (translation, rotation) holds for every
/// 6-vector and 6x6 covariance of this SDK.
template <class = void>
Eigen::Isometry3d expSe3(const Vector6d& twist) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = expSo3(twist.tail<3>());
  T.translation() = leftJacobianSo3(twist.tail<3>()) * twist.head<3>();
  return T;
}

/// Rigid motion to twist (rho, rotation); inverse of expSe3 for angles below pi.
template <class = void>
Vector6d logSe3(const Eigen::Isometry3d& T) {
  Vector6d twist;
  twist.tail<3>() = logSo3(T.linear());
  twist.head<3>() = leftJacobianSo3(twist.tail<3>()).partialPivLu().solve(T.translation());
  return twist;
}

/// Adjoint of SE(3): T * expSe3(n) == expSe3(adjointSe3(T) * n) * T. A covariance of T_a_b in the
/// tangent space of b, as in every record, becomes one in the tangent space of a by A * P * A'.
template <class = void>
Matrix6d adjointSe3(const Eigen::Isometry3d& T) {
  Matrix6d A = Matrix6d::Zero();
  A.topLeftCorner<3, 3>() = T.linear();
  A.bottomRightCorner<3, 3>() = T.linear();
  A.topRightCorner<3, 3>() = skew(T.translation()) * T.linear();
  return A;
}

/// The nearest rotation (by quaternion normalisation): keeps long products of poses rigid.
template <class = void>
Eigen::Isometry3d normalised(const Eigen::Isometry3d& T) {
  Eigen::Isometry3d rigid = T;
  rigid.linear() = Eigen::Quaterniond(T.linear()).normalized().toRotationMatrix();
  return rigid;
}

/// A pose on the ground plane; see the axes at the top of this header.
struct PlanarPose {
  double x = 0;      ///< m, forward
  double y = 0;      ///< m, left
  double theta = 0;  ///< rad, counter-clockwise, in [-pi, pi)
};

/// a followed by b, where b is given in the coordinates of a.
inline PlanarPose compose(const PlanarPose& a, const PlanarPose& b) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  return {a.x + c * b.x - s * b.y, a.y + s * b.x + c * b.y, wrapAngle(a.theta + b.theta)};
}

/// The motion from a to b, in the coordinates of a: compose(a, between(a, b)) == b.
inline PlanarPose between(const PlanarPose& a, const PlanarPose& b) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  return {c * dx + s * dy, -s * dx + c * dy, wrapAngle(b.theta - a.theta)};
}

/// Projects a camera pose (or motion) onto the plane spanned by the reference camera's x and z
/// axes; theta is the direction of the optical axis in that plane.
template <class = void>
PlanarPose toPlanar(const Eigen::Isometry3d& T_reference_camera) {
  const Eigen::Vector3d t = T_reference_camera.translation();
  const Eigen::Vector3d axis = T_reference_camera.linear().col(2);
  return {t.z(), -t.x(), std::atan2(-axis.x(), axis.z())};
}

/// The pose in camera axes of a planar pose: no height, no pitch, no roll. toPlanar is its inverse.
template <class = void>
Eigen::Isometry3d fromPlanar(const PlanarPose& pose) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() << -pose.y, 0, pose.x;
  T.linear() = Eigen::AngleAxisd(-pose.theta, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return T;
}

}  // namespace tolman
