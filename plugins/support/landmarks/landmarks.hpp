// SPDX-License-Identifier: BSD-3-Clause
// Landmarks of a template: corners of a stereo pair with their position (m, camera frame of the
// template) and their ORB descriptor (Rublee et al. 2011).
#pragma once

#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::landmarks {

/// Corners of one image with their descriptions.
struct Corners {
  std::vector<cv::Point2f> pixels;
  cv::Mat descriptions;  ///< CV_8U, a row of kDescriptionBytes for each
  double sigma = 1;      ///< standard deviation of a corner that is found again, px
};
inline constexpr int kDescriptionBytes = 32;  // of ORB: 256 bits

/// Landmarks in the coordinates of the left camera, m.
struct Landmarks {
  std::vector<cv::Point3f> points;
  cv::Mat descriptions;  ///< as those of Corners
};

/// Fewest landmarks that must agree on a pose, of views that keep at most `corners`: one in 25, as
/// 20 of 500, where a false pose was never seen; at least 6, since any three give a pose.
constexpr int leastAgreeing(int corners) { return std::clamp(corners / 25, 6, 20); }

/// Shares the pixels of a grey image; converts a colour one.
cv::Mat grayOf(const Image& image);

/// At most `count` corners of a grey image, found at reduced width (reduced_image.hpp);
/// deterministic.
Corners findCorners(const cv::Mat& gray, int count);

/// The corners of the left image that have a match in the right one, with their positions.
Landmarks findLandmarks(const cv::Mat& left, const cv::Mat& right, const CameraRig& rig,
                        const Corners& corners);

/// Sub-pixel disparity of a pixel of the left image (px), at most `largest`; negative if no match
/// is good or two are equally good.
double disparityAt(const cv::Mat& left, const cv::Mat& right, const cv::Point2f& pixel,
                   double largest);

}  // namespace tolman::landmarks
