// SPDX-License-Identifier: BSD-3-Clause
// Tracks a frame against the reference: tries the expected motion first, then other hypotheses, and
// accepts or rejects the best alignment.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "alignment.hpp"
#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

/// Prediction for a frame, before its image is used.
struct Expectation {
  Eigen::Isometry3d T_reference_previous = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_previous_current = Eigen::Isometry3d::Identity();
  bool has_velocity = false;  ///< false: T_previous_current is not known
  Affine brightness;
};

class Tracker {
 public:
  /// Required share of inliers: for measured depths, for assumed ones (see monocular_start.hpp), or
  /// where features have found the pose before (see feature_guess.hpp).
  enum class Demand : std::uint8_t { Certain, Guess, Confirmed };

  void reset();
  /// Makes the newest keyframe the reference; false if it has too few points for tracking.
  bool setReference(const CameraRig& rig, const Window& window);
  /// Pose of the frame, or none if no alignment is accepted. `image` has the size of the reference.
  std::optional<AlignmentResult> track(const CameraRig& rig, const ImagePyramid& image,
                                       const Expectation& expectation,
                                       Demand demand = Demand::Certain);
  /// The same from a single guess: the pose of the reference in the frame.
  std::optional<AlignmentResult> refine(const CameraRig& rig, const ImagePyramid& image,
                                        const AlignmentState& guess);
  /// RMS of the first frame after the reference; 0 before.
  double firstRms() const { return first_rms_; }

 private:
  bool accept(const CameraRig& rig, AlignmentResult& result, Demand demand);
  AlignmentResult bestOf(const CameraRig& rig, const ImagePyramid& image,
                         const Expectation& expectation);

  AlignmentReference reference_;
  Aligner aligner_;
  double last_rms_ = 0;  ///< 0: not known
  double usual_samples_ = 0;
  double first_rms_ = 0;
};

// Start of a single camera: assumed depths (1/m) for the first keyframe, against which frames are
// tracked until their motion has determined the real ones.

/// Assigns each candidate its inverse depth in a street of ground and two side walls. `height`: of
/// the camera above the ground, m. The shape need only be close enough for tracking; the standard
/// deviation is half the inverse depth.
void draftDepths(const CameraRig& rig, double height, Keyframe& keyframe);

/// Makes points at the present depths of all candidates, for tracking; they have no residuals.
void draftPoints(Keyframe& keyframe);

}  // namespace tolman::direct_sparse
