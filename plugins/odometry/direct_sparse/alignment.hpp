// SPDX-License-Identifier: BSD-3-Clause
// Tracking (Engel et al., PAMI 2018, section 3.1): the pose of a frame relative to the newest
// keyframe by direct image alignment, coarse to fine, with affine brightness. Lengths m, angles
// rad.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

// Reference for tracking: all active points projected into the newest keyframe, as samples on each
// pyramid level with derivatives that are the same for all frames (inverse composition; Baker and
// Matthews, IJCV 2004).

/// Samples of one level as parallel arrays, padded to whole SIMD groups with weight 0.
struct ReferenceLevel {
  static constexpr std::size_t kGroup = 8;
  std::vector<float> x, y, d;  ///< ray (x, y, 1) and inverse depth in the keyframe
  std::vector<float> value;    ///< grey level
  std::vector<float> weight;
  std::array<std::vector<float>, 6> by_twist;  ///< derivative by the motion of the point
  std::size_t count = 0;                       ///< without padding

  std::size_t groups() const { return (count + kGroup - 1) / kGroup; }
  /// Removes all samples and reserves memory for `most`.
  void makeRoom(std::size_t most);
  void pad();
};

class AlignmentReference {
 public:
  /// Projects all points of the window into its newest keyframe.
  void build(const CameraRig& rig, const Window& window);
  int levels() const { return levels_; }
  const ReferenceLevel& level(int l) const { return samples_[static_cast<std::size_t>(l)]; }
  std::int64_t frame() const { return frame_; }
  void clear() { levels_ = 0; }

 private:
  struct Projected {
    float u = 0;
    float v = 0;
    float d = 0;
  };
  void project(const CameraRig& rig, const Window& window);
  /// Sets the number of samples of a level and d; leaves their pixels in x and y.
  void placeSamples(const GrayLevel& image, int l);
  /// Replaces pixels by rays, and sets everything else.
  void sampleLevel(const CameraRig& rig, const GrayLevel& image, int l);

  std::array<ReferenceLevel, ImagePyramid::kMaxLevels> samples_;
  std::vector<Projected> projected_;
  /// For each level: which pixels have a sample.
  std::array<std::vector<unsigned char>, ImagePyramid::kMaxLevels> taken_;
  int levels_ = 0;
  std::int64_t frame_ = -1;
};

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
