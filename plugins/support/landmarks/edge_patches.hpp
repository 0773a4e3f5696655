// SPDX-License-Identifier: BSD-3-Clause
// Finds landmarks again when the light has changed, as from day to night, where binary descriptors
// of corners fail. Corners need not be found again: the surroundings of a landmark, described by
// their edges, are searched in a window of the current image.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "edge_map.hpp"
#include "landmark_pose.hpp"

namespace tolman::landmarks {

inline constexpr int kPatchBytes = 48;

/// Edges at 4 x 4 cells around a pixel, 3 cells apart: 96 values of four bits, of a vector of
/// constant length.
using EdgePatch = std::array<std::uint8_t, kPatchBytes>;

/// Where a point of the camera frame is seen.
cv::Point2f pixelOf(const cv::Point3f& point, const Pinhole& pinhole);

/// `pixel`: of the full image; near the border the nearest cell within.
EdgePatch patchAt(const EdgeMap& map, const cv::Point2f& pixel);

/// Where landmarks are seen in an image that was taken near the template.
class EdgeSearch {
 public:
  /// `map`: of the image; must exist as long as this.
  explicit EdgeSearch(const EdgeMap& map);

  /// For each landmark the position with the most similar patch, at most a tenth of the image's
  /// width to the sides and a 44th up or down from where it was in the template, unless another
  /// position is about as similar. `patches` has one for each of `points`; with `step` only every
  /// step-th landmark is searched.
  std::vector<LandmarkMatch> find(const std::vector<cv::Point3f>& points,
                                  const std::vector<EdgePatch>& patches, const Pinhole& pinhole,
                                  std::size_t step = 1) const;

  /// Standard deviation of the pixels that are found, px of the full image.
  double sigma() const;

 private:
  const EdgeMap& map_;
  std::vector<float> lengths_;  ///< of the patches at all cells, as 1 / length; 0 for empty ones
};

}  // namespace tolman::landmarks
