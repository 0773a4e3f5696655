// SPDX-License-Identifier: BSD-3-Clause
// Lucas-Kanade through OpenCV, forward and backward.
#include "tracking.hpp"

#include <opencv2/video/tracking.hpp>

namespace tolman::feature_stereo {
namespace {

std::vector<uchar> flow(const FlowPyramid& from_image, const FlowPyramid& to_image,
                        const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to,
                        const TrackSettings& settings) {
  std::vector<uchar> found;
  std::vector<float> error;
  // OpenCV's defaults: steps, px, and smallest eigenvalue.
  const cv::TermCriteria stop(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01);
  constexpr double kWeakestTexture = 1e-4;
  cv::calcOpticalFlowPyrLK(from_image.images(), to_image.images(), from, to, found, error,
                           {settings.window, settings.window}, settings.levels - 1, stop,
                           cv::OPTFLOW_USE_INITIAL_FLOW, kWeakestTexture);
  return found;
}

bool inside(const cv::Point2f& point, const cv::Size& size) {
  // px of the centre from the border; the patch may exceed it. Chosen, not tuned.
  constexpr float kMargin = 3;
  return point.x >= kMargin && point.y >= kMargin &&
         point.x < static_cast<float>(size.width) - kMargin &&
         point.y < static_cast<float>(size.height) - kMargin;
}

}  // namespace

FlowPyramid::FlowPyramid(const cv::Mat& gray, const TrackSettings& settings) {
  cv::buildOpticalFlowPyramid(gray, images_, {settings.window, settings.window},
                              settings.levels - 1, true, cv::BORDER_REFLECT_101,
                              cv::BORDER_CONSTANT, false);
}

std::vector<bool> trackCorners(const FlowPyramid& from_image, const FlowPyramid& to_image,
                               const std::vector<cv::Point2f>& from, std::vector<cv::Point2f>& to,
                               const TrackSettings& settings) {
  std::vector<bool> good(from.size(), false);
  if (from.empty()) return good;
  const std::vector<uchar> found = flow(from_image, to_image, from, to, settings);
  std::vector<cv::Point2f> back = from;
  const std::vector<uchar> returned = flow(to_image, from_image, to, back, settings);
  for (std::size_t i = 0; i < from.size(); ++i) {
    good[i] = found[i] != 0 && returned[i] != 0 && inside(to[i], to_image.size()) &&
              cv::norm(back[i] - from[i]) <= settings.consistency;
  }
  return good;
}

}  // namespace tolman::feature_stereo
