// SPDX-License-Identifier: BSD-3-Clause
// What a template remembers of a stereo pair beside its looks: corners with their place in space
// and a description by which they are found again (ORB; Rublee et al. 2011).
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "tolman/camera.hpp"

namespace tolman::view_templates {

/// Corners of one image with their descriptions.
struct Corners {
  std::vector<cv::Point2f> pixels;
  cv::Mat descriptions;  ///< CV_8U, a row of kDescriptionBytes for each
};
inline constexpr int kDescriptionBytes = 32;

/// A place's landmarks, in the frame of its left camera; m.
struct Landmarks {
  std::vector<cv::Point3f> points;
  cv::Mat descriptions;  ///< as those of Corners
};

/// At most `count` corners of a grey image, the same each time.
Corners findCorners(const cv::Mat& gray, int count);

/// Those corners of the left image that the right one shows as well.
Landmarks findLandmarks(const cv::Mat& left, const cv::Mat& right, const CameraRig& rig,
                        const Corners& corners);

/// Disparity of a pixel of the left image, to a part of a pixel; negative where the right image
/// shows nothing like it, or two places as good.
double disparityAt(const cv::Mat& left, const cv::Mat& right, const cv::Point2f& pixel,
                   double largest);

}  // namespace tolman::view_templates
