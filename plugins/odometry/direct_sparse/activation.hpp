// SPDX-License-Identifier: BSD-3-Clause
// Activation of candidate points (Engel et al., PAMI 2018, section 3.2): chooses candidates that
// are evenly spaced in the newest keyframe and refines their inverse depth (1/m) over all
// keyframes.
#pragma once

#include <optional>
#include <vector>

#include "linear_system.hpp"

namespace tolman::direct_sparse {

/// Grid over the newest image that keeps points a minimum spacing (px) apart.
class Occupancy {
 public:
  void reset(int width, int height, float spacing);
  /// Occupies (u, v) and returns true, unless another point lies within the spacing.
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

/// Gauss-Newton on the inverse depth over all keyframes; empty without enough good residuals.
std::optional<Point> refineCandidate(const CameraRig& rig, const SystemSettings& settings,
                                     const Window& window, int host,
                                     const std::vector<PairGeometry>& pairs,
                                     const ImmaturePoint& candidate);

/// Keeps the spacing and the buffers from keyframe to keyframe.
class Activator {
 public:
  void reset() {
    spacing_ = 0;
    last_count_ = 0;
  }
  /// Adds a residual to the newest keyframe to every point of the window, then activates candidates
  /// up to about `wanted` points in the window.
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
