// SPDX-License-Identifier: BSD-3-Clause
// Intensity profile of an image region: mean brightness of each column, resampled over the bearing
// (Milford and Wyeth 2008).
#pragma once

#include <vector>

#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::scanline {

/// Part of an image, as fractions of its width and height.
struct Region {
  double x_min = 0;
  double x_max = 1;
  double y_min = 0;
  double y_max = 1;
};

/// Samples at equal steps of bearing, left to right, in [0, 1].
using Profile = std::vector<float>;

/// Resamples image columns at equal steps of bearing, so that a turn of the camera shifts the whole
/// profile by the same amount. The columns of a pinhole camera shift more at the edges than at the
/// centre.
class ProfileMaker {
 public:
  /// As many samples as the region has columns. An uncalibrated camera is assumed to have
  /// `field_of_view` (rad) over its width, with the same angle between all columns.
  ProfileMaker(const CameraRig& rig, const Region& region, double field_of_view);

  /// The image must have the rig's size; colour counts as the mean of its channels.
  Profile make(const Image& image) const;
  double radiansPerSample() const { return radians_per_sample_; }
  int samples() const { return static_cast<int>(columns_.size()); }

 private:
  int first_column_ = 0;
  int column_count_ = 0;
  int first_row_ = 0;
  int row_count_ = 0;
  double radians_per_sample_ = 0;
  std::vector<double> columns_;  ///< column of each sample, relative to first_column_
};

/// Standard deviation of a profile; without contrast no motion can be measured.
double contrastOf(const Profile& profile);

}  // namespace tolman::scanline
