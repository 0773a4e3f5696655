// SPDX-License-Identifier: BSD-3-Clause
// Pose of the camera relative to the frame of a template, m and rad. Landmarks are matched by their
// ORB descriptors; RANSAC over P3P finds a pose, and Gauss-Newton refines it over its inliers.
#pragma once

#include <optional>
#include <vector>

#include "landmarks.hpp"
#include "tolman/geometry.hpp"

namespace tolman::landmarks {

/// A landmark of the template, in its frame (m), and the pixel of the current image that it
/// matches.
struct LandmarkMatch {
  cv::Point3f point;
  cv::Point2f pixel;
};

struct MeasuredPose {
  Eigen::Isometry3d T_template_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
  int inliers = 0;
};

/// Matches each landmark to the corner with the nearest descriptor; ambiguous matches are left out.
std::vector<LandmarkMatch> findAgain(const Landmarks& landmarks, const Corners& corners);

/// How many landmarks agreed on a pose, of how many that were found again, and how many must.
struct Agreement {
  int agreeing = -1;  ///< -1: none were compared
  int compared = -1;
  int needed = -1;
};

/// Empty if fewer than `least` matches agree. `sigma`: standard deviation of a matched pixel, px.
std::optional<MeasuredPose> poseOf(const std::vector<LandmarkMatch>& matches,
                                   const Pinhole& pinhole, int least, double sigma,
                                   Agreement* agreement = nullptr);

}  // namespace tolman::landmarks
