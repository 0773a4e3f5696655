// SPDX-License-Identifier: BSD-3-Clause
// From candidates to points of the window: even spacing in the newest keyframe, and an inverse
// depth on which all keyframes agree (algorithms: 5.6).
#pragma once

#include <optional>
#include <vector>

#include "linear_system.hpp"

namespace tolman::direct_sparse {

/// Cells of the newest image that are taken.
class Occupancy {
 public:
  void reset(int width, int height, float spacing);
  /// True and taken from now on, unless something lies within the spacing.
  bool claim(float u, float v);

 private:
  struct Cell {
    float u = -1e6F;
    float v = -1e6F;
  };
  float spacing_ = 1;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Cell> cells_;
};

/// Inverse depth by Gauss-Newton over all keyframes; none if too few agree.
std::optional<Point> refineCandidate(const CameraRig& rig, const SystemSettings& settings,
                                     const Window& window, int host,
                                     const std::vector<PairGeometry>& pairs,
                                     const ImmaturePoint& candidate);

/// Chooses and activates; keeps what it needs from keyframe to keyframe.
class Activator {
 public:
  void reset() {
    spacing_ = 0;
    last_count_ = 0;
  }
  /// Aims at `wanted` points in the window. Every point of the window gets a residual to the newest
  /// keyframe before.
  void activate(const CameraRig& rig, const SystemSettings& settings, int wanted, Window& window);

 private:
  struct Candidate {
    int host = 0;
    std::size_t index = 0;
  };
  void adaptSpacing(const CameraRig& rig, int wanted);
  void chooseFrom(int host, Window& window, const PairGeometry* to_newest);

  float spacing_ = 0;           ///< px; 0 before the first keyframe
  std::size_t last_count_ = 0;  ///< points in the window after the last activation
  Occupancy occupancy_;
  std::vector<Candidate> chosen_;
  std::vector<std::optional<Point>> refined_;
  std::vector<PairGeometry> pairs_;
};

}  // namespace tolman::direct_sparse
