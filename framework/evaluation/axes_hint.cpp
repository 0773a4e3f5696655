// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/axes_hint.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <cmath>
#include <numbers>

namespace tolman::evaluation {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kApart = 45 * kDegree;
constexpr double kTogether = 15 * kDegree;

Eigen::Vector3d step(const Trajectory& path, std::size_t i) {
  return (path[i - 1].T_world_camera.inverse() * path[i].T_world_camera).translation();
}

/// Sums over all steps; weighted by length, so that standing still counts for nothing.
struct Steps {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();  ///< of true and estimated steps
  double lengths = 0;                                  ///< products of their lengths
};

Steps stepsOf(const Trajectory& truths, const Trajectory& estimates) {
  Steps sums;
  for (std::size_t i = 1; i < truths.size(); ++i) {
    if (!estimates[i].tracked) continue;
    const Eigen::Vector3d truth = step(truths, i);
    const Eigen::Vector3d estimate = step(estimates, i);
    sums.products += truth * estimate.transpose();
    sums.lengths += truth.norm() * estimate.norm();
  }
  return sums;
}

Trajectory inverted(Trajectory path) {
  for (TrajectoryPose& pose : path) pose.T_world_camera = pose.T_world_camera.inverse();
  return path;
}

/// Angle whose cosine is the mean of cosines, weighted by length.
double meanAngle(double sum, const Steps& steps) {
  return std::acos(std::min(1.0, std::max(-1.0, sum / steps.lengths)));
}

}  // namespace

std::string axesHint(const Matches& matches) {
  constexpr std::size_t kFewest = 10;  // frames
  const Steps steps = stepsOf(matches.truth, matches.estimate);
  if (matches.size() < kFewest || !(steps.lengths > 0)) return "";
  const double apart = meanAngle(steps.products.trace(), steps);
  if (apart < kApart) return "";
  const Steps other = stepsOf(inverted(matches.truth), matches.estimate);
  if (meanAngle(other.products.trace(), other) < kTogether) {
    return "the true poses, read as world to camera, agree with the estimate, and as camera to "
           "world they do not: write camera-to-world poses. All errors are wrong until then";
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(steps.products,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Vector3d s = svd.singularValues();
  const double together = meanAngle(s[0] + s[1] + sign * s[2], steps);
  if (together > kTogether) return "";
  return fmt::format(
      "true and estimated motion point in directions {:.0f} degrees apart, but in the same way "
      "all along: are the true poses camera to world, of the left camera (x right, y down, z "
      "forward), with quaternions as x y z w? Rotation errors, drift and NEES are wrong if not",
      apart / kDegree);
}

}  // namespace tolman::evaluation
