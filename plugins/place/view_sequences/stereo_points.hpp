// SPDX-License-Identifier: BSD-3-Clause
// Points from one stereo pair, by block matching at a reduced size.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::view_sequences {

/// A point in camera axes, cm: within 327 m.
using CentimetrePoint = Eigen::Matrix<std::int16_t, 3, 1>;

class StereoPoints {
 public:
  explicit StereoPoints(const CameraRig& rig);

  /// A calibrated stereo pair whose images are wide enough.
  bool canMeasure() const { return can_measure_; }
  /// Points at depths from 3 to 25 m and within 20 m to the sides, about 2,000 in a street; empty
  /// for images without texture.
  std::vector<CentimetrePoint> pointsOf(const Frame& frame) const;

 private:
  double scale_ = 1;    ///< size of the matched images relative to the rig's
  Pinhole pinhole_;     ///< of the matched images
  double product_ = 0;  ///< focal length times baseline, px m
  int disparities_ = 0;
  bool can_measure_ = false;
};

}  // namespace tolman::view_sequences
