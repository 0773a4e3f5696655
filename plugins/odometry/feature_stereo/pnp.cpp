// SPDX-License-Identifier: BSD-3-Clause
// RANSAC over P3P (with our own random stream) and robust Gauss-Newton steps.
#include "pnp.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

namespace tolman::feature_stereo {
namespace {

constexpr double kNoInformation = 1e9;  // px^2, variance of a disparity that was not measured

struct Hypothesis {
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  double cost = 0;  ///< sum of truncated squares
};

/// Poses and weights of one call.
class PoseProblem {
 public:
  PoseProblem(const CameraRig& rig, const std::vector<PointMatch>& matches,
              const PnpSettings& settings)
      : rig_(rig), matches_(matches), settings_(settings), weights_(matches.size()) {}

  /// Weights each match by the inverse of its covariance at this pose: the pixel noise plus the
  /// uncertainty of the point. So far and new points have less weight.
  void weigh(const Eigen::Isometry3d& T_world_camera) {
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      const PointMatch& s = matches_[i];
      ProjectionJacobians J;
      const auto predicted = project(rig_, T_world_camera, s.point, &J);
      Eigen::Vector3d variances =
          settings_.noise.sigma(predicted ? predicted->z() : s.pixel.z()).cwiseAbs2();
      if (!s.has_disparity) variances.z() = kNoInformation;
      Eigen::Matrix3d covariance = variances.asDiagonal();
      if (predicted) covariance += J.point * s.point_covariance * J.point.transpose();
      weights_[i] = covariance.inverse();
    }
  }

  /// Squared Mahalanobis distance; infinite for a point behind the camera.
  double distance(std::size_t i, const Eigen::Isometry3d& T_world_camera) const {
    const auto predicted = project(rig_, T_world_camera, matches_[i].point);
    if (!predicted) return std::numeric_limits<double>::infinity();
    const StereoPixel error = residual(i, *predicted);
    return error.dot(weights_[i] * error);
  }

  double cost(const Eigen::Isometry3d& T_world_camera) const {
    double sum = 0;
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      sum += std::min(distance(i, T_world_camera), kGate);
    }
    return sum;
  }

  /// One Gauss-Newton step with Cauchy weights; false when the normal equations are singular.
  bool step(Eigen::Isometry3d& T_world_camera, Matrix6d& information) const {
    information.setZero();
    Vector6d gradient = Vector6d::Zero();
    for (std::size_t i = 0; i < matches_.size(); ++i) {
      ProjectionJacobians J;
      const auto predicted = project(rig_, T_world_camera, matches_[i].point, &J);
      if (!predicted) continue;
      const StereoPixel error = residual(i, *predicted);
      const double squared = error.dot(weights_[i] * error);
      if (squared > kGate) continue;
      const double robust = 1 / (1 + squared / kCauchy);
      const Eigen::Matrix<double, 6, 3> weighted = robust * J.pose.transpose() * weights_[i];
      information += weighted * J.pose;
      gradient += weighted * error;
    }
    const Eigen::LDLT<Matrix6d> factor(information);
    // Singular up to rounding.
    if (factor.info() != Eigen::Success || factor.rcond() < 1e-14) return false;
    const Vector6d update = factor.solve(gradient);
    if (!update.allFinite()) return false;
    T_world_camera = normalised(T_world_camera * expSe3(update));
    return true;
  }

 private:
  static constexpr double kCauchy = 5.7;  // (2.385)^2: 95 % efficient for normal errors

  StereoPixel residual(std::size_t i, const StereoPixel& predicted) const {
    StereoPixel error = matches_[i].pixel - predicted;
    if (!matches_[i].has_disparity) error.z() = 0;
    return error;
  }

  const CameraRig& rig_;
  const std::vector<PointMatch>& matches_;
  const PnpSettings& settings_;
  std::vector<Eigen::Matrix3d> weights_;
};

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

/// RANSAC samples needed for one without outlier, with 99.9 % confidence.
double samplesNeeded(double cost, std::size_t count) {
  // 0.01 and 1e-9 keep the logarithms finite.
  const double inliers = std::max(0.01, 1 - cost / (kGate * double(count)));
  return std::log(1e-3) / std::log(std::max(1e-9, 1 - inliers * inliers * inliers));
}

Hypothesis bestSample(const CameraRig& rig, const std::vector<PointMatch>& matches,
                      const PoseProblem& problem, const Eigen::Isometry3d& guess, int iterations,
                      RandomStream& random) {
  Hypothesis best{guess, problem.cost(guess)};
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
      const double cost = problem.cost(pose);
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
  PoseProblem problem(rig, matches, settings);
  problem.weigh(guess);
  PoseEstimate estimate;
  estimate.T_world_camera =
      bestSample(rig, matches, problem, guess, settings.iterations, random).T_world_camera;
  // Reweighted least squares converges linearly; a fixed number makes the time per frame constant.
  constexpr int kSteps = 8;  // chosen, not tuned
  Matrix6d information = Matrix6d::Zero();
  for (int k = 0; k < kSteps; ++k) {
    problem.weigh(estimate.T_world_camera);
    if (!problem.step(estimate.T_world_camera, information)) return std::nullopt;
  }
  double squares = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const double squared = problem.distance(i, estimate.T_world_camera);
    estimate.inlier.push_back(squared < kGate);
    if (!estimate.inlier.back()) continue;
    ++estimate.inliers;
    squares += squared;
  }
  if (estimate.inliers < settings.min_inliers) return std::nullopt;
  const double misfit = squares / (3.0 * estimate.inliers - 6);  // 1 when the sigmas are right
  estimate.covariance = std::max(1.0, misfit) * information.inverse();
  return estimate;
}

}  // namespace tolman::feature_stereo
