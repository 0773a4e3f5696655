// SPDX-License-Identifier: BSD-3-Clause
// Tracking (Engel et al., PAMI 2018, section 3.1): the pose of a frame relative to the newest
// keyframe by direct image alignment, coarse to fine, with affine brightness. Lengths m, angles
// rad.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "alignment_reference.hpp"
#include "tolman/geometry.hpp"

namespace tolman::direct_sparse {

/// Pose and brightness of a frame against the reference.
struct AlignmentState {
  Eigen::Isometry3d T_current_reference = Eigen::Isometry3d::Identity();
  Affine brightness;  ///< current = e^a * reference + b
};

struct AlignmentResult {
  AlignmentState state;
  double rms = 0;              ///< grey levels, of all samples in view, large residuals truncated
  double inlier_fraction = 0;  ///< of the samples in view
  double in_view = 0;          ///< fraction of all samples that are in view
  int samples = 0;             ///< inliers at the finest level
  Eigen::Matrix<double, 8, 8> information = Eigen::Matrix<double, 8, 8>::Zero();
  double flow = 0;              ///< px, root mean square image motion since the reference
  double translation_flow = 0;  ///< px, the same without rotation
  double coverage = 1;          ///< part of the reference's image area that still has samples
};

class Aligner {
 public:
  /// Sums of samples: upper triangle of [J a b r]' W [J a b r], energy, squares, inliers, in view.
  static constexpr std::size_t kColumns = 9;
  static constexpr std::size_t kSums = kColumns * (kColumns + 1) / 2 + 4;

  /// Aligns on the levels from `coarsest` down to `finest`, starting at `guess`.
  AlignmentResult align(const CameraRig& rig, const AlignmentReference& reference,
                        const ImagePyramid& image, const AlignmentState& guess, int coarsest,
                        int finest);

 private:
  struct NormalEquations {
    Eigen::Matrix<double, 8, 8> H;
    Vector8d b;
    double energy = 0;  ///< mean over the samples in view
    double squares = 0;
    double inliers = 0;
    double in_view = 0;
  };
  /// H hardly changes within a level, so it is computed once; the gradient in every iteration.
  enum class Sought : std::uint8_t { GradientAndH, Gradient };
  void evaluate(const CameraRig& rig, const ReferenceLevel& level, const GrayLevel& image, int l,
                const AlignmentState& state, float cutoff, Sought sought, NormalEquations& normal);
  void alignLevel(const CameraRig& rig, const ReferenceLevel& level, const GrayLevel& image, int l,
                  AlignmentState& state, NormalEquations& normal);

  using Sums = std::array<float, kSums>;
  static void sumChunk(const CameraRig& rig, const ReferenceLevel& level, const GrayLevel& image,
                       int l, const AlignmentState& state, float cutoff, Sought sought,
                       std::size_t begin, std::size_t end, Sums& sums);
  std::vector<Sums> chunks_;
};

/// Fills flow and coverage. Flow is in pixels of level 0; that of a point is limited to
/// kLargestFlow, so that a few near points do not dominate the mean.
void measureFlow(const CameraRig& rig, const AlignmentReference& reference,
                 AlignmentResult& result);

}  // namespace tolman::direct_sparse
