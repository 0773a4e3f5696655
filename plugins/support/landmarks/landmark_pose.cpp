// SPDX-License-Identifier: BSD-3-Clause
#include "landmark_pose.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

namespace tolman::landmarks {
namespace {

constexpr double kInlier = 3;  // standard deviations; chosen, not tuned
using Jacobian = Eigen::Matrix<double, 2, 6>;

cv::Matx33d matrixOf(const Pinhole& K) { return {K.fx, 0, K.cx, 0, K.fy, K.cy, 0, 0, 1}; }

constexpr double kConfidence = 0.999;

/// Samples of four matches, of which one has no wrong match at the confidence above, where only
/// `least` of `count` matches are right (Fischler and Bolles 1981).
int samplesFor(int least, std::size_t count) {
  constexpr double kMost = 200;  // bounds the time; chosen, not tuned
  const double all_right = std::pow(std::min(1.0, least / static_cast<double>(count)), 4);
  if (all_right == 1) return 1;
  return static_cast<int>(
      std::ceil(std::min(kMost, std::log(1 - kConfidence) / std::log1p(-all_right))));
}

/// RANSAC over P3P. OpenCV uses a constant seed, so the result is reproducible.
std::optional<Eigen::Isometry3d> consensus(const std::vector<LandmarkMatch>& matches,
                                           const Pinhole& pinhole, int least, double sigma) {
  std::vector<cv::Point3f> points;
  std::vector<cv::Point2f> pixels;
  for (const LandmarkMatch& match : matches) {
    points.push_back(match.point);
    pixels.push_back(match.pixel);
  }
  cv::Vec3d rotation;
  cv::Vec3d translation;
  const bool found = cv::solvePnPRansac(points, pixels, matrixOf(pinhole), cv::noArray(), rotation,
                                        translation, false, samplesFor(least, points.size()),
                                        static_cast<float>(kInlier * sigma), kConfidence,
                                        cv::noArray(), cv::SOLVEPNP_AP3P);
  if (!found) return std::nullopt;
  Eigen::Isometry3d T_current_template = Eigen::Isometry3d::Identity();
  T_current_template.linear() = expSo3({rotation[0], rotation[1], rotation[2]});
  T_current_template.translation() << translation[0], translation[1], translation[2];
  return T_current_template.inverse();
}

/// Gauss-Newton normal equations of the reprojection errors of all inliers.
struct PoseEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  int inliers = 0;
};

PoseEquations poseEquationsOf(const std::vector<LandmarkMatch>& matches, const Pinhole& K,
                              const Eigen::Isometry3d& T_template_current, double sigma) {
  PoseEquations normal;
  const Eigen::Isometry3d T_current_template = T_template_current.inverse();
  for (const LandmarkMatch& match : matches) {
    const Eigen::Vector3d p =
        T_current_template * Eigen::Vector3d(match.point.x, match.point.y, match.point.z);
    if (p.z() < 0.1) continue;  // m; keeps the projection finite
    const Eigen::Vector2d error = Eigen::Vector2d(match.pixel.x, match.pixel.y) - K.project(p);
    if (error.norm() > kInlier * sigma) continue;
    Eigen::Matrix<double, 2, 3> projection;
    projection << K.fx / p.z(), 0, -K.fx * p.x() / (p.z() * p.z()), 0, K.fy / p.z(),
        -K.fy * p.y() / (p.z() * p.z());
    // A motion (rho, theta) of the current frame changes p by -rho - theta x p.
    Jacobian J;
    J.leftCols<3>() = -projection;
    J.rightCols<3>() = projection * skew(p);
    normal.H += J.transpose() * J / (sigma * sigma);
    normal.b += J.transpose() * error / (sigma * sigma);
    ++normal.inliers;
  }
  return normal;
}

}  // namespace

std::vector<LandmarkMatch> findAgain(const Landmarks& landmarks, const Corners& corners) {
  std::vector<LandmarkMatch> matches;
  if (landmarks.points.empty() || corners.pixels.size() < 2) return matches;
  constexpr float kFarthest = 64;  // of 256 bits; chosen, not tuned
  constexpr float kRival = 0.8F;   // ratio test (Lowe, IJCV 2004)
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING)
      .knnMatch(landmarks.descriptions, corners.descriptions, nearest, 2);
  for (const std::vector<cv::DMatch>& two : nearest) {
    if (two[0].distance > kFarthest || two[0].distance > kRival * two[1].distance) continue;
    matches.push_back({landmarks.points[static_cast<std::size_t>(two[0].queryIdx)],
                       corners.pixels[static_cast<std::size_t>(two[0].trainIdx)]});
  }
  return matches;
}

std::optional<MeasuredPose> poseOf(const std::vector<LandmarkMatch>& matches,
                                   const Pinhole& pinhole, int least, double sigma,
                                   Agreement* agreement) {
  if (agreement != nullptr) *agreement = {0, static_cast<int>(matches.size()), least};
  if (static_cast<int>(matches.size()) < least) return std::nullopt;
  const std::optional<Eigen::Isometry3d> start = consensus(matches, pinhole, least, sigma);
  if (!start) return std::nullopt;
  MeasuredPose measured;
  measured.T_template_current = *start;
  PoseEquations normal = poseEquationsOf(matches, pinhole, *start, sigma);
  constexpr int kSteps = 5;  // fixed, bounds the time; chosen, not tuned
  for (int step = 0; step < kSteps && normal.inliers >= least; ++step) {
    measured.T_template_current =
        normalised(measured.T_template_current * expSe3(Vector6d(normal.H.ldlt().solve(normal.b))));
    normal = poseEquationsOf(matches, pinhole, measured.T_template_current, sigma);
  }
  if (agreement != nullptr) agreement->agreeing = normal.inliers;
  if (normal.inliers < least) return std::nullopt;
  measured.inliers = normal.inliers;
  measured.covariance = normal.H.ldlt().solve(Matrix6d::Identity());
  measured.covariance = 0.5 * (measured.covariance + measured.covariance.transpose().eval());
  const bool usable =
      measured.covariance.allFinite() && measured.covariance.diagonal().minCoeff() > 0;
  return usable ? std::optional(measured) : std::nullopt;
}

}  // namespace tolman::landmarks
