// SPDX-License-Identifier: BSD-3-Clause
// Corners with depth of a stereo pair.
//
// Images in which landmarks are looked for: reduced to a width of about 620 px, so that the time
// does not grow with the camera's resolution.
#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::landmarks {

/// Pixels of a whole image, in one direction, for one of the reduced image.
inline int reductionOf(int columns) {
  constexpr double kWidth = 620;  // px: half of KITTI's, in whose size the constants were chosen
  return std::max(1, static_cast<int>(std::lround(columns / kWidth)));
}

/// Means over squares of `factor` pixels; what is left over at the right and below is cut off.
inline cv::Mat reducedBy(int factor, const cv::Mat& gray) {
  if (factor == 1) return gray;
  const cv::Size size(gray.cols / factor, gray.rows / factor);
  cv::Mat reduced;
  if (size.empty()) return reduced;
  cv::resize(gray(cv::Rect(0, 0, size.width * factor, size.height * factor)), reduced, size, 0, 0,
             cv::INTER_AREA);
  return reduced;
}

/// The place in the whole image of a place in the reduced one, px; centres of pixels are whole.
inline cv::Point2f wholeOf(const cv::Point2f& reduced, int factor) {
  const auto f = static_cast<float>(factor);
  return {(reduced.x + 0.5F) * f - 0.5F, (reduced.y + 0.5F) * f - 0.5F};
}

// Landmarks of a template: corners of a stereo pair with their position (m, camera frame of the
// template) and their ORB descriptor (Rublee et al. 2011).

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
