// SPDX-License-Identifier: BSD-3-Clause
// The active window: keyframes in fixed slots, and the prior from marginalisation.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "disparity_field.hpp"
#include "keyframe.hpp"
#include "tolman/camera.hpp"

namespace tolman::direct_sparse {

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
