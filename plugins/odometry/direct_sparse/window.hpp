// SPDX-License-Identifier: BSD-3-Clause
// A keyframe of the window: images, points, pose and affine brightness. Poses are T_camera_world,
// in m; inverse depths are in 1/m.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "disparity_field.hpp"
#include "gradient_samples.hpp"
#include "pyramid.hpp"
#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"

namespace tolman::direct_sparse {

/// Slots for keyframes in the window; a slot is also the position of its variables in the linear
/// system. One more than the largest `window`.
inline constexpr int kSlots = 8;

using Vector8d = Eigen::Matrix<double, 8, 1>;

/// Brightness of a frame: a scene value I is seen as e^a I + b.
struct Affine {
  double a = 0;
  double b = 0;  ///< grey levels
};

enum class ResidualState : std::uint8_t {
  Absent,  ///< never evaluated, or removed
  Good,
  Outlier,  ///< energy too large, or no gradient
  Outside,  ///< projects out of the image
};

/// Grey values and weights of a point's pattern in its host.
struct Pattern {
  alignas(32) std::array<float, kPatternSize> value{};
  alignas(32) std::array<float, kPatternSize> weight{};
};

/// A point whose inverse depth is a variable of the window.
struct Point {
  float u = 0;  ///< px in the host
  float v = 0;
  float inverse_depth = 0;  ///< 1/m
  float information = 0;    ///< of the inverse depth, from all residuals of the last solution
  Pattern pattern;
  std::array<ResidualState, kSlots> temporal{};  ///< by the target's slot
  ResidualState stereo = ResidualState::Absent;
  int seen_good = 0;  ///< number of good residuals so far
};

/// A selected pixel whose depth is not yet accurate enough to become a Point.
struct ImmaturePoint {
  float u = 0;
  float v = 0;
  float inverse_depth = 0;  ///< 1/m
  float sigma = 0;          ///< 1/m
  float quality = 0;        ///< error of the second best match over that of the best
  float last_interval = 0;  ///< px, length of the last search
  int failures = 0;
  bool has_depth = false;  ///< false: any inverse depth is possible
  Pattern pattern;
};

struct Keyframe {
  std::int64_t frame = -1;
  ImagePyramid left;
  ImagePyramid right;
  bool has_right = false;
  float right_gain = 1;    ///< right image = gain * left image + offset
  float right_offset = 0;  ///< grey levels

  /// State: exp(change.head<6>()) * T0_camera_world, affine0.a + change[6], affine0.b + change[7].
  Eigen::Isometry3d T0_camera_world = Eigen::Isometry3d::Identity();
  Affine affine0;
  Vector8d change = Vector8d::Zero();
  bool has_prior = false;  ///< the prior is linearised at T0, which must not change any more

  std::vector<Point> points;
  std::vector<ImmaturePoint> immature;
  int points_made = 0;  ///< number of points that it has hosted in total

  Eigen::Isometry3d T_camera_world() const {
    const Vector6d twist = change.head<6>();
    return normalised(expSe3(twist) * T0_camera_world);
  }
  Eigen::Isometry3d T_world_camera() const { return T_camera_world().inverse(); }
  Affine affine() const { return {affine0.a + change[6], affine0.b + change[7]}; }
  /// Sets the first estimate to the present state.
  void relinearise() {
    T0_camera_world = T_camera_world();
    affine0 = affine();
    change.setZero();
  }
};

/// The grey values around a pixel, with the gradient weights; the pixel must be kPatternRadius + 1
/// away from the border.
inline Pattern patternAt(const GrayLevel& image, int u, int v) {
  Pattern pattern;
  for (std::size_t k = 0; k < kPatternSize; ++k) {
    const int x = u + kPatternU[k];
    const int y = v + kPatternV[k];
    pattern.value[k] = static_cast<float>(image.row(y)[x]);
    pattern.weight[k] = gradientWeight(gradientSquared(image, x, y));
  }
  return pattern;
}

// The active window: keyframes in fixed slots, and the prior from marginalisation.

/// Variables of the linear system: eight per slot (6 for the pose, affine brightness a and b), then
/// the coefficients of the field of disparity errors, of which the first is an offset.
inline constexpr int kFrameVariables = 8;
inline constexpr int kOffsetIndex = kSlots * kFrameVariables;
inline constexpr int kFieldVariables = SmoothField::kTerms;
inline constexpr int kVariables = kOffsetIndex + kFieldVariables;

using SystemMatrix = Eigen::Matrix<double, kVariables, kVariables>;
using SystemVector = Eigen::Matrix<double, kVariables, 1>;

/// Quadratic energy in the changes of the variables from their first estimates:
/// x' H x / 2 + b' x.
struct Prior {
  SystemMatrix H = SystemMatrix::Zero();
  SystemVector b = SystemVector::Zero();
};

/// Index in arrays that have an element for each slot.
inline std::size_t indexOfSlot(int slot) { return static_cast<std::size_t>(slot); }

class Window {
 public:
  /// First outlier threshold, squared grey levels summed over a pattern: 12 grey levels per pixel.
  /// As in DSO (Engel et al.)
  static constexpr float kFirstThreshold = 12 * 12 * kPatternSize;

  void clear();
  bool empty() const { return order_.empty(); }
  int size() const { return static_cast<int>(order_.size()); }
  /// Slots from the oldest keyframe to the newest.
  const std::vector<int>& order() const { return order_; }
  Keyframe& keyframe(int slot) { return keyframes_[indexOfSlot(slot)]; }
  const Keyframe& keyframe(int slot) const { return keyframes_[indexOfSlot(slot)]; }
  Keyframe& newest() { return keyframe(order_.back()); }
  const Keyframe& newest() const { return keyframe(order_.back()); }
  int newestSlot() const { return order_.back(); }
  const Keyframe* find(std::int64_t frame) const;

  /// Makes a free slot the newest keyframe; its buffers are emptied, not freed. The caller makes
  /// sure that a slot is free.
  Keyframe& add();
  /// Frees the slot. The caller has marginalised its variables.
  void remove(int slot);
  std::size_t pointCount() const;

  Prior prior;
  DisparityField field;
  ScaleMoments<double> moments;              ///< of all static residuals since the window began
  float energy_threshold = kFirstThreshold;  ///< a residual of larger pattern energy is an outlier

 private:
  std::array<Keyframe, kSlots> keyframes_;
  std::vector<int> order_;
};

/// Positions (m) of about `most` points, chosen evenly from all keyframes, in a camera at
/// T_camera_world. Some may lie behind it.
std::vector<Eigen::Vector3d> somePositions(const Pinhole& camera, const Window& window,
                                           const Eigen::Isometry3d& T_camera_world,
                                           std::size_t most);

}  // namespace tolman::direct_sparse
