// SPDX-License-Identifier: BSD-3-Clause
// The two plugins of feature-based odometry.
#pragma once

#include "feature_odometry.hpp"

namespace tolman::feature_stereo {

/// Of a calibrated, rectified stereo pair.
class FeatureStereo final : public FeatureOdometry {
 public:
  using Parameters = feature_stereo::Parameters;
  FeatureStereo() : FeatureOdometry(DisparityFrom::RightImage) {}
};

/// Of a calibrated camera with depth images that are registered to it. A right image is not used.
class FeatureRgbd final : public FeatureOdometry {
 public:
  using Parameters = RgbdParameters;
  FeatureRgbd() : FeatureOdometry(DisparityFrom::DepthImage) {}
};

}  // namespace tolman::feature_stereo
