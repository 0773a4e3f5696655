// SPDX-License-Identifier: BSD-3-Clause
// Whether the values of an answer can be recorded: finite, within the limits of a record
// (config/limits.hpp), enumerators with a name, orthonormal rotations. Arrays: see arrays.hpp.
#pragma once

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "config/limits.hpp"
#include "tolman/fields.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// The first field with a wrong value, with its enclosing fields ("revisions.covariance").
struct ValueProblem {
  std::string field;
  const char* what = nullptr;  ///< null: no problem
};

inline constexpr const char* kIllegal = "the answer has NaN, infinity or an illegal value in '{}'";
inline constexpr const char* kTooLarge =
    "'{}' is larger than a record takes: numbers to 1e100, integers to 2^62";
inline constexpr const char* kTooFar = "'{}' is farther than a record takes (1e12 m)";
inline constexpr const char* kNoRotation =
    "the rotation of '{}' is not orthonormal; use normalised()";
inline constexpr const char* kNoPose =
    "the last row of '{}' is not 0 0 0 1; the translation is the last column";

template <class T>
concept MatrixValue = std::is_base_of_v<Eigen::DenseBase<T>, T>;

inline const char* wrongIn(const Eigen::Isometry3d& T) {
  if (!T.matrix().allFinite()) return kIllegal;
  if (T.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1)) return kNoPose;
  if (!config::isRotation(T.linear())) return kNoRotation;
  return config::isNear(T.translation()) ? nullptr : kTooFar;
}

/// The problem of a value that is neither a record nor a list of records; null if it has none.
template <class T>
const char* wrongIn(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(value)) return kIllegal;
    return std::abs(value) <= config::kMaxNumber ? nullptr : kTooLarge;
  } else if constexpr (NamedEnum<T>) {
    return static_cast<std::size_t>(value) < enumNames(value).size() ? nullptr : kIllegal;
  } else if constexpr (std::is_same_v<T, std::int64_t>) {
    return value >= -config::kMaxInteger && value <= config::kMaxInteger ? nullptr : kTooLarge;
  } else if constexpr (MatrixValue<T>) {
    if (!value.allFinite()) return kIllegal;
    if constexpr (std::is_same_v<typename T::Scalar, double>) {
      return (value.array().abs() <= config::kMaxNumber).all() ? nullptr : kTooLarge;
    }
  }
  return nullptr;  // not checked: shorter integers, text, pixels
}

template <Record R>
ValueProblem problemOf(const R& record);

template <class T>
ValueProblem problemOf(const T& value) {
  return {"", wrongIn(value)};
}

template <Record R>
ValueProblem problemOf(const std::vector<R>& records) {
  ValueProblem problem;
  for (const R& record : records) {
    if (problem = problemOf(record); problem.what != nullptr) break;
  }
  return problem;
}

inline ValueProblem problemOf(const std::vector<NamedArray>&) { return {}; }

template <Record R>
ValueProblem problemOf(const R& record) {
  ValueProblem first;
  visitFields(record, [&](const Field& field, const auto& value) {
    if (first.what != nullptr) return;
    first = problemOf(value);
    if (first.what == nullptr) return;
    first.field = std::string(field.name) + (first.field.empty() ? "" : "." + first.field);
  });
  return first;
}

Status statusOf(const ValueProblem& problem);

template <class T>
Status checkValues(const T& record) {
  const ValueProblem problem = problemOf(record);
  return problem.what == nullptr ? Status::ok() : statusOf(problem);
}

// Whether named arrays and their descriptions can be recorded and shown.

/// Checks number, names, shapes and values of the arrays of one frame.
Status checkArrays(const std::vector<NamedArray>& arrays);

/// Checks names, texts and numbers of descriptions.
Status checkDescriptions(std::span<const ArrayInfo> arrays);

/// Checks that names and shapes of the arrays of a plugin stay the same over a run. Call only one
/// of the two functions.
class ArrayShapes {
 public:
  /// checkArrays(), and requires the names and shapes of the first call.
  Status check(const std::vector<NamedArray>& arrays);
  /// checkArrays(), and requires that an array keeps its shape, except for the length of the first
  /// axis. Arrays may be missing, because a sensor need not measure at each frame.
  Status checkShapes(const std::vector<NamedArray>& arrays);

 private:
  std::map<std::string, std::vector<int>, std::less<>> known_;  // empty: not known yet
};

}  // namespace tolman::host
