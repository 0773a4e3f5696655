// SPDX-License-Identifier: BSD-3-Clause
// The largest values that a run may have. The host refuses answers of plugins beyond them, and the
// reader of a record refuses rows beyond them, so that what is recorded can be read.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tolman::config {

/// Differences of stamps and frames fit their type.
inline constexpr std::int64_t kMaxInteger = std::int64_t{1} << 62U;
/// Squares of numbers up to this one are finite.
inline constexpr double kMaxNumber = 1e100;
inline constexpr double kFarthest = 1e12;  // m, of each coordinate of a position
/// Largest element of |R'R - 1|. A rotation in single precision has about 1e-6.
inline constexpr double kRotationError = 1e-4;
inline constexpr std::size_t kMaxArrays = 256;    // of a frame, in one record
inline constexpr std::size_t kLongestName = 100;  // bytes, of an array

/// Also false for NaN.
inline bool isNear(const Eigen::Vector3d& position) {
  return (position.array().abs() <= kFarthest).all();
}

/// Whether a quaternion of unit length describes this matrix. False for mirrors and NaN.
inline bool isRotation(const Eigen::Matrix3d& R) {
  const Eigen::Matrix3d error = R.transpose() * R - Eigen::Matrix3d::Identity();
  return (error.array().abs() <= kRotationError).all() && R.determinant() > 0;
}

/// Whether an array of this shape has `count` values.
inline bool shapeFits(const std::vector<int>& shape, std::size_t count) {
  std::size_t size = 1;
  for (const int side : shape) {
    if (side < 0 || (side > 0 && size > count / static_cast<std::size_t>(side))) return false;
    size *= static_cast<std::size_t>(side);
  }
  return size == count;
}

}  // namespace tolman::config
