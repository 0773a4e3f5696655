// SPDX-License-Identifier: BSD-3-Clause
// RANSAC over OpenCV's P3P, with samples from the plugin's random stream, and robust Gauss-Newton
// steps.
#include "pnp.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "pose_lanes.hpp"

namespace tolman::feature_stereo {
namespace {

struct Hypothesis {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  double cost = 0;  ///< sum of truncated squares
};

/// One Gauss-Newton step with Cauchy weights; empty when the normal equations are
/// singular.
std::optional<Vector6d> stepOf(const PoseLanes& problem, const Eigen::Isometry3d& T_world_camera,
                               Matrix6d& information) {
  Vector6d gradient;
  problem.linearise(T_world_camera, kGate, information, gradient);
  const Eigen::LDLT<Matrix6d> factor(information);
  // Singular up to rounding.
  if (factor.info() != Eigen::Success || factor.rcond() < 1e-14) return std::nullopt;
  const Vector6d update = factor.solve(gradient);
  if (!update.allFinite()) return std::nullopt;
  return update;
}

/// Matches whose depth is accurate enough for P3P.
std::vector<std::size_t> triangulated(const std::vector<PointMatch>& matches) {
  // Chosen, not derived: P3P takes the three points as exact; the refinement then weights them.
  constexpr double kRelative = 0.1;
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const double sigma = std::sqrt(matches[i].point_covariance(2, 2));
    if (matches[i].point.coordinates.z() > std::max(1e-6, sigma / kRelative)) known.push_back(i);
  }
  return known;
}

/// The up to four poses that solve P3P. Points are given in the axes of `guess`, where their
/// coordinates are small.
std::vector<Eigen::Isometry3d> solveThree(const CameraRig& rig,
                                          const std::array<const PointMatch*, 3>& three,
                                          const Eigen::Isometry3d& guess) {
  std::vector<cv::Point3d> points;
  std::vector<cv::Point2d> rays;
  for (const PointMatch* s : three) {
    const Eigen::Vector3d p = scaledCameraPoint(guess, s->point) / s->point.coordinates.z();
    const Eigen::Vector3d ray = rig.pinhole.ray(s->pixel.head<2>());
    points.emplace_back(p.x(), p.y(), p.z());
    rays.emplace_back(ray.x(), ray.y());
  }
  std::vector<cv::Vec3d> rotations;
  std::vector<cv::Vec3d> translations;
  cv::solveP3P(points, rays, cv::Matx33d::eye(), cv::noArray(), rotations, translations,
               cv::SOLVEPNP_AP3P);
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    Eigen::Isometry3d T_camera_guess = Eigen::Isometry3d::Identity();
    T_camera_guess.linear() = expSo3({rotations[k][0], rotations[k][1], rotations[k][2]});
    T_camera_guess.translation() << translations[k][0], translations[k][1], translations[k][2];
    if (T_camera_guess.matrix().allFinite()) poses.push_back(guess * T_camera_guess.inverse());
  }
  return poses;
}

/// Number of RANSAC samples of which, with 99.9 % confidence, one has no outlier. The share of
/// inliers is estimated from the truncated cost.
double samplesNeeded(double cost, std::size_t count) {
  // 0.01 and 1e-9 keep the logarithms finite.
  const double inliers = std::max(0.01, 1 - cost / (kGate * double(count)));
  return std::log(1e-3) / std::log(std::max(1e-9, 1 - inliers * inliers * inliers));
}

Hypothesis bestSample(const CameraRig& rig, const std::vector<PointMatch>& matches,
                      const PoseLanes& problem, const Eigen::Isometry3d& guess, int iterations,
                      RandomStream& random) {
  Hypothesis best{guess, problem.cost(guess, kGate)};
  const std::vector<std::size_t> known = triangulated(matches);
  if (known.size() < 3) return best;
  for (int k = 0; k < iterations && k < samplesNeeded(best.cost, matches.size()); ++k) {
    const std::size_t a = random.below(known.size());
    const std::size_t b = random.below(known.size());
    const std::size_t c = random.below(known.size());
    if (a == b || b == c || a == c) continue;
    const std::array<const PointMatch*, 3> three = {&matches[known[a]], &matches[known[b]],
                                                    &matches[known[c]]};
    for (const Eigen::Isometry3d& pose : solveThree(rig, three, guess)) {
      const double cost = problem.cost(pose, kGate);
      if (cost < best.cost) best = {pose, cost};
    }
  }
  return best;
}

}  // namespace

std::optional<PoseEstimate> estimatePose(const CameraRig& rig,
                                         const std::vector<PointMatch>& matches,
                                         const Eigen::Isometry3d& guess,
                                         const PnpSettings& settings, RandomStream& random) {
  if (static_cast<int>(matches.size()) < settings.min_inliers) return std::nullopt;
  PoseLanes problem(rig, matches, settings.noise);
  problem.weigh(guess);
  PoseEstimate estimate;
  estimate.T_world_camera =
      bestSample(rig, matches, problem, guess, settings.iterations, random).T_world_camera;
  // Reweighted least squares converges linearly; a fixed number makes the time per frame constant.
  constexpr int kSteps = 8;  // chosen, not tuned
  Matrix6d information = Matrix6d::Zero();
  for (int k = 0; k < kSteps; ++k) {
    problem.weigh(estimate.T_world_camera);
    const auto step = stepOf(problem, estimate.T_world_camera, information);
    if (!step) return std::nullopt;
    estimate.T_world_camera = normalised(estimate.T_world_camera * expSe3(*step));
  }
  double squares = 0;
  for (const double squared : problem.distances(estimate.T_world_camera)) {
    estimate.inlier.push_back(squared < kGate);
    if (!estimate.inlier.back()) continue;
    ++estimate.inliers;
    squares += squared;
  }
  if (estimate.inliers < settings.min_inliers) return std::nullopt;
  // About 1 if the sigmas are right, and less for matches without a disparity.
  const double misfit = squares / (3.0 * estimate.inliers - 6);
  estimate.covariance = std::max(1.0, misfit) * information.inverse();
  return estimate;
}

}  // namespace tolman::feature_stereo
