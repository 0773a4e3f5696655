// SPDX-License-Identifier: BSD-3-Clause
// Loops over groups of four matches.
#include "pose_lanes.hpp"

#include <limits>

namespace tolman::feature_stereo {
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
