// SPDX-License-Identifier: BSD-3-Clause
// Where the camera is now, seen from where a template was made: landmarks found again, a pose that
// enough of them agree on, and its covariance.
#pragma once

#include <optional>
#include <vector>

#include "landmarks.hpp"
#include "tolman/geometry.hpp"

namespace tolman::view_templates {

/// A landmark of the template and where it is seen now.
struct Sighting {
  cv::Point3f point;
  cv::Point2f pixel;
};

struct MeasuredPose {
  Eigen::Isometry3d T_template_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
  int inliers = 0;
};

/// Each landmark with the corner that is described most alike, unless a second one is nearly so.
std::vector<Sighting> findAgain(const Landmarks& landmarks, const Corners& corners);

/// None when fewer than `least` sightings agree.
std::optional<MeasuredPose> poseOf(const std::vector<Sighting>& sightings, const Pinhole& pinhole,
                                   int least);

}  // namespace tolman::view_templates
