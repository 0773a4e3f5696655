// SPDX-License-Identifier: BSD-3-Clause
// Whole-pixel disparities: a patch is compared with all places of its row.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "flow_pyramid.hpp"

namespace tolman::feature_stereo {

/// Compares patches of the left image with those on the same row of the right one.
class RowSearch {
 public:
  RowSearch(const PaddedImage& left, const PaddedImage& right, int max_disparity);

  /// The best disparity by sums of absolute differences, with the patches' means removed;
  /// kNoDisparity if the best is not clearly better than the second best.
  float find(cv::Point corner);

  /// The sums for disparities from 0 on; empty for a corner near the border.
  const std::vector<int>& costsAt(cv::Point corner);

 private:
  PaddedImage left_;
  PaddedImage right_;
  int max_disparity_;
  std::vector<int> costs_;
};

}  // namespace tolman::feature_stereo
