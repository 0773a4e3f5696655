// SPDX-License-Identifier: BSD-3-Clause
// Whether the values of an answer can be recorded: finite, within the limits of a record,
// enumerators with a name, orthonormal rotations; arrays that keep their
// shapes, images that fit the cameras, and cameras that can exist.
#pragma once

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

// The largest values that a run may have.

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

/// Requires valid pixels, rows that do not overlap, and the sizes of the rig; and of a pair either
/// both images in one format or none.
Status checkImages(const Frame& frame, const CameraRig& rig);

/// Refuses sizes and baselines below 0, and calibrated cameras without focal lengths. The engine
/// warns of unusual cameras (engine/camera_check.hpp).
Status checkRig(const CameraRig& rig);

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
  if (!isRotation(T.linear())) return kNoRotation;
  return isNear(T.translation()) ? nullptr : kTooFar;
}

/// The problem of a value that is neither a record nor a list of records; null if it has none.
template <class T>
const char* wrongIn(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(value)) return kIllegal;
    return std::abs(value) <= kMaxNumber ? nullptr : kTooLarge;
  } else if constexpr (NamedEnum<T>) {
    return static_cast<std::size_t>(value) < enumNames(value).size() ? nullptr : kIllegal;
  } else if constexpr (std::is_same_v<T, std::int64_t>) {
    return value >= -kMaxInteger && value <= kMaxInteger ? nullptr : kTooLarge;
  } else if constexpr (MatrixValue<T>) {
    if (!value.allFinite()) return kIllegal;
    if constexpr (std::is_same_v<typename T::Scalar, double>) {
      return (value.array().abs() <= kMaxNumber).all() ? nullptr : kTooLarge;
    }
  }
  return nullptr;  // not checked: shorter integers, text, pixels
}

/// Names the first field with a wrong value, after the fields that enclose it
/// ("revisions.covariance").
template <Record R>
Status checkValues(const R& record, std::string_view enclosing = {}) {
  Status status;
  const auto check = [&](const auto& value, std::string_view name) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (Record<T>) {
      return checkValues(value, fmt::format("{}{}.", enclosing, name));
    } else {
      const char* what = wrongIn(value);
      return what == nullptr ? Status::ok()
                             : Status::failed(fmt::format(fmt::runtime(what),
                                                          fmt::format("{}{}", enclosing, name)));
    }
  };
  visitFields(record, [&](const Field& field, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<T, std::vector<NamedArray>>) {
      // checkArrays()
    } else if constexpr (requires { requires Record<typename T::value_type>; }) {
      for (const auto& one : value) {
        if (status.isOk()) status = check(one, field.name);
      }
    } else {
      if (status.isOk()) status = check(value, field.name);
    }
  });
  return status;
}

// Whether named arrays and their descriptions can be recorded and shown.

/// Checks number, names, shapes and values of the arrays of one frame.
Status checkArrays(const std::vector<NamedArray>& arrays);

/// Checks names and numbers of descriptions.
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

// Checks the answers of the roles against the contract of the SDK. Frame, stamp and values are
// checked in stages.hpp and above.

/// Requires a symmetric, positive semidefinite matrix, up to rounding; zero is allowed. `field`:
/// its name.
Status checkCovariance(const Matrix6d& covariance, const char* field);

/// Requires that only frames `oldest` to `newest` are revised.
Status checkRevisions(const std::vector<MotionRevision>& revisions, std::int64_t oldest,
                      std::int64_t newest);

/// `is_first`: the first motion of a session.
Status checkMotion(const Motion& motion, bool is_first);

/// Requires the next template id for a novel view, and an existing one for a familiar view.
/// `templates`: number so far, -1 if not known.
Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates);

/// Checks the covariance of an observation with a relative pose.
Status checkPlace(const PlaceObservation& observation);

/// Checks a decision of cells that localise (Localiser) in a map with so many experiences.
Status checkLocalised(const Decision& decision, std::int64_t experiences);

/// `experiences`: number before this decision. `last`: the experience of the decision before; below
/// -1: not known. `templates`: ids below it were given by place recognition.
Status checkDecision(const Decision& decision, std::int64_t experiences, std::int64_t last,
                     std::int64_t templates = INT64_MAX);

/// `last_version`: version of the previous update.
Status checkUpdate(const MapUpdate& update, std::int64_t last_version);

/// What is known of a map from its answers so far.
struct KnownMap {
  std::int64_t newest_frame = INT64_MAX;  ///< newest answered frame; INT64_MAX: not known
  std::int64_t version = INT64_MIN;       ///< of the last update; INT64_MIN: not known
  std::int64_t experiences = -1;          ///< at the last update; -1: not known
  std::int64_t links = -1;                ///< the same; includes rejected links
  std::int64_t loops = -1;                ///< the same
  std::int64_t templates = INT64_MAX;     ///< that decisions named; INT64_MAX: not known
};

/// Checks ids, frames and values of experiences and links, and that they agree with `known`.
Status checkGraph(const MapGraph& graph, const KnownMap& known);

/// Requires that the pose of an update is that of its experience in the graph, composed with
/// T_experience_camera. `graph` must belong to the update.
Status checkPlaced(const MapUpdate& update, const MapGraph& graph);

/// Requires that poseOf() and another answer give a frame the same pose. `what` names the other
/// answer: "the update".
Status checkSamePose(const Eigen::Isometry3d& T_world_camera, const Eigen::Isometry3d& other,
                     const std::string& what);

}  // namespace tolman::host
