// SPDX-License-Identifier: BSD-3-Clause
// RANSAC over OpenCV's P3P, with samples from the plugin's random stream, and robust Gauss-Newton
// steps.
#include "pnp.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

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

// Loops over groups of four matches.

namespace {

constexpr double kNoInformation = 1e9;  // px^2, variance of a disparity that was not measured
constexpr double kCauchy = 5.7;         // (2.385)^2: 95 % efficient for normal errors
constexpr double kNotSeen = 1e30;       // the distance of a point that is not seen

using PoseGroup = PoseLanes::Group;

/// J P J' + V for the variances V.
TOLMAN_INLINE Four6 spread(const LaneByPoint& J, const Four6& P, const Four3& variances) {
  std::array<Four3, 3> JP;
  for (std::size_t i = 0; i < 3; ++i) {
    JP[i] = {J[i][0] * P[0] + J[i][1] * P[1] + J[i][2] * P[2],
             J[i][0] * P[1] + J[i][1] * P[3] + J[i][2] * P[4],
             J[i][0] * P[2] + J[i][1] * P[4] + J[i][2] * P[5]};
  }
  const auto entry = [&](std::size_t i, std::size_t j) TOLMAN_INLINE_LAMBDA {
    return JP[i][0] * J[j][0] + JP[i][1] * J[j][1] + JP[i][2] * J[j][2];
  };
  return {entry(0, 0) + variances[0], entry(0, 1), entry(0, 2),
          entry(1, 1) + variances[1], entry(1, 2), entry(2, 2) + variances[2]};
}

TOLMAN_INLINE Four3 errorsOf(const PoseGroup& group, const LaneProjection& p) {
  return {group.pixel[0] - p.fromCentre[0], group.pixel[1] - p.fromCentre[1],
          group.has_disparity * (group.pixel[2] - p.fromCentre[2])};
}

TOLMAN_INLINE Four distanceOf(const PoseGroup& group, const LaneProjection& p) {
  const Four3 error = errorsOf(group, p);
  return select(p.front, dot(error, product(group.weights, error)), four(kNotSeen));
}

TOLMAN_WIDE_LANES
void weighGroups(const LaneCamera& camera, const PlainPose& pose, const PixelNoise& noise,
                 std::vector<PoseGroup>& groups) {
  for (PoseGroup& group : groups) {
    const LaneProjection p = projected(camera, pose, group.scaled, group.inverse_depth);
    // A point behind the camera has derivatives of 0: only the noise counts.
    const Four disparity = select(p.front, p.fromCentre[2], group.pixel[2]);
    const Four ratio = disparity * (1 / noise.doubling);
    const Four growth = 1.0 + ratio * ratio;
    const Four track = noise.track * noise.track * growth;
    const Four measured = noise.disparity * noise.disparity * growth;
    const Four across = select(group.has_disparity > 0.5, measured, four(kNoInformation));
    const LaneByPoint J = derivativesByPoint(camera, pose, group.reference, p);
    group.weights = inverseOf(spread(J, group.covariance, {track, track, across}));
  }
}

TOLMAN_WIDE_LANES
void measureGroups(const LaneCamera& camera, const PlainPose& pose,
                   const std::vector<PoseGroup>& groups, double* distances) {
  for (const PoseGroup& group : groups) {
    const Four distance =
        distanceOf(group, projected(camera, pose, group.scaled, group.inverse_depth));
    for (int lane = 0; lane < kFour; ++lane) *distances++ = distance[lane];
  }
}

TOLMAN_WIDE_LANES
double costOfGroups(const LaneCamera& camera, const PlainPose& pose,
                    const std::vector<PoseGroup>& groups, double gate) {
  Four sum = {};
  for (const PoseGroup& group : groups) {
    const Four distance =
        distanceOf(group, projected(camera, pose, group.scaled, group.inverse_depth));
    sum += group.has_match * select(distance < gate, distance, four(gate));
  }
  return sumOf(sum);
}

/// Sums of the upper triangle of the information, row by row, and of the gradient.
struct PoseSums {
  Fours<21> information = {};
  Four6 gradient = {};
};

TOLMAN_WIDE_LANES
void addGroups(const LaneCamera& camera, const PlainPose& pose,
               const std::vector<PoseGroup>& groups, double gate, PoseSums& sums) {
  for (const PoseGroup& group : groups) {
    const LaneProjection p = projected(camera, pose, group.scaled, group.inverse_depth);
    const Four3 error = errorsOf(group, p);
    const Four3 e = product(group.weights, error);
    const Four squared = dot(error, e);
    const Four robust = select(p.front & (squared <= gate),
                               group.has_match / (1.0 + squared * (1 / kCauchy)), Four{});
    const LaneByPose J = derivativesByPose(camera, p, group.inverse_depth);
    std::size_t k = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const Four3 column = product(group.weights, {J[0][i], J[1][i], J[2][i]});
      const Four3 scaled = {robust * column[0], robust * column[1], robust * column[2]};
      for (std::size_t j = i; j < 6; ++j) {
        sums.information[k++] += scaled[0] * J[0][j] + scaled[1] * J[1][j] + scaled[2] * J[2][j];
      }
      sums.gradient[i] += dot(scaled, error);
    }
  }
}

}  // namespace

PoseLanes::PoseLanes(const CameraRig& rig, const std::vector<PointMatch>& matches,
                     const PixelNoise& noise)
    : camera_(rig), noise_(noise), count_(matches.size()), groups_((count_ + kFour - 1) / kFour) {
  for (std::size_t i = 0; i < count_; ++i) {
    const PointMatch& match = matches[i];
    const std::size_t lane = i % kFour;
    Group& group = groups_[i / kFour];
    group.reference.set(lane, match.point.T_world_reference);
    const Eigen::Vector3d& c = match.point.coordinates;
    const Eigen::Vector3d scaled =
        match.point.T_world_reference.linear() * Eigen::Vector3d(c.x(), c.y(), 1) +
        c.z() * match.point.T_world_reference.translation();
    group.inverse_depth[lane] = c.z();
    group.has_match[lane] = 1;
    group.has_disparity[lane] = match.has_disparity ? 1 : 0;
    std::size_t k = 0;
    for (Eigen::Index row = 0; row < 3; ++row) {
      const auto n = static_cast<std::size_t>(row);
      group.scaled[n][lane] = scaled[row];
      for (Eigen::Index column = row; column < 3; ++column) {
        group.covariance[k++][lane] = match.point_covariance(row, column);
      }
    }
    group.pixel[0][lane] = match.pixel.x() - camera_.cx;
    group.pixel[1][lane] = match.pixel.y() - camera_.cy;
    group.pixel[2][lane] = match.has_disparity ? match.pixel.z() : 0;
  }
}

void PoseLanes::weigh(const Eigen::Isometry3d& T_world_camera) {
  weighGroups(camera_, PlainPose(T_world_camera), noise_, groups_);
}

std::vector<double> PoseLanes::distances(const Eigen::Isometry3d& T_world_camera) const {
  std::vector<double> all(kFour * groups_.size());
  measureGroups(camera_, PlainPose(T_world_camera), groups_, all.data());
  all.resize(count_);
  return all;
}

double PoseLanes::cost(const Eigen::Isometry3d& T_world_camera, double gate) const {
  return costOfGroups(camera_, PlainPose(T_world_camera), groups_, gate);
}

void PoseLanes::linearise(const Eigen::Isometry3d& T_world_camera, double gate,
                          Matrix6d& information, Vector6d& gradient) const {
  PoseSums sums;
  addGroups(camera_, PlainPose(T_world_camera), groups_, gate, sums);
  std::size_t k = 0;
  for (Eigen::Index i = 0; i < 6; ++i) {
    gradient[i] = sumOf(sums.gradient[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = i; j < 6; ++j) {
      information(i, j) = information(j, i) = sumOf(sums.information[k++]);
    }
  }
}

}  // namespace tolman::feature_stereo
