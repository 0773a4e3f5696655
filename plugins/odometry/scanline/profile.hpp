// SPDX-License-Identifier: BSD-3-Clause
// Intensity profiles of an image region, and the shift between two of them.
//
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

// Compares two profiles: the shift with the smallest mean absolute difference, and that difference
// (Milford and Wyeth 2008).

struct ProfileMatch {
  /// Shift of the scene to the right from the earlier to the later profile, in samples,
  /// interpolated.
  double moved_right = 0;
  double difference = 0;  ///< mean absolute difference at the best whole shift
  /// Half the width, in samples, of the range of shifts that are nearly as good.
  double uncertainty = 0;
  int compared = 0;  ///< samples that overlap at the best shift
};

/// Tries all shifts up to `largest_shift` to both sides; of equal differences the smaller shift is
/// taken. The mean of each overlap is subtracted first, so a change of exposure has no effect. The
/// profiles have the same length; at least half of it must overlap, which limits the shift.
ProfileMatch matchProfiles(const Profile& earlier, const Profile& later, int largest_shift);

}  // namespace tolman::scanline
