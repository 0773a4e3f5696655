// SPDX-License-Identifier: BSD-3-Clause
// Reference for tracking: all active points projected into the newest keyframe, as samples on each
// pyramid level with derivatives that are the same for all frames (inverse composition; Baker and
// Matthews, IJCV 2004).
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

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

}  // namespace tolman::direct_sparse
