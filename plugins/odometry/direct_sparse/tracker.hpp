// SPDX-License-Identifier: BSD-3-Clause
// Finds a frame: the expected motion first, then others, and judges whether the best is true.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "alignment.hpp"

namespace tolman::direct_sparse {

/// What is known before the images are looked at.
struct Expectation {
  Eigen::Isometry3d T_reference_previous = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_previous_current = Eigen::Isometry3d::Identity();
  bool has_velocity = false;  ///< else the motion above says nothing
  Affine brightness;
};

class Tracker {
 public:
  /// How well the images must agree: as in a known scene, or in one that is guessed itself.
  enum class Demand : std::uint8_t { Certain, Guess };

  void reset();
  /// A new keyframe is the reference; false when it has too few points to track from.
  bool setReference(const CameraRig& rig, const Window& window);
  /// The frame's pose, or none: lost. `image` must have the reference's size.
  std::optional<AlignmentResult> track(const CameraRig& rig, const Pyramid& image,
                                       const Expectation& expectation,
                                       Demand demand = Demand::Certain);
  /// RMS of the first frame after the reference; 0 before.
  double firstRms() const { return first_rms_; }

 private:
  AlignmentResult bestOf(const CameraRig& rig, const Pyramid& image,
                         const Expectation& expectation);

  AlignmentReference reference_;
  Aligner aligner_;
  double last_rms_ = 0;  ///< 0: not known
  double first_rms_ = 0;
};

}  // namespace tolman::direct_sparse
