// SPDX-License-Identifier: BSD-3-Clause
// Landmarks in inverse depth and their projection into a rectified stereo pair.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "lanes.hpp"
#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"

namespace tolman::feature_stereo {

/// The measurement of a point in one stereo frame: u, v of the left image and the disparity d, px.
/// An error of the tracker shifts u equally in both images, so the errors of (u, v, d) are
/// independent, those of (u_left, v, u_right) are not.
using StereoPixel = Eigen::Vector3d;

/// Largest squared error of an inlier, in variances: 99 % quantile of chi-square with 3 degrees of
/// freedom.
inline constexpr double kGate = 11.34;

/// Accuracy of a StereoPixel. The appearance of near points changes more between images than that
/// of far ones, so their errors grow with the disparity d: sigma(d) = sigma(0) sqrt(1 +
/// (d/doubling)^2). On road scenes (KITTI) one `doubling` fits tracks and disparities; with a
/// constant sigma the least accurate measurements would determine the scale.
struct PixelNoise {
  double track = 0.25;      ///< px, of u and of v, for far points
  double disparity = 0.15;  ///< px, for far points
  double doubling = 14;     ///< px of disparity

  /// Standard deviations of u, v and d at this disparity.
  Eigen::Vector3d sigma(double at_disparity) const {
    const double ratio = at_disparity / doubling;
    return std::sqrt(1 + ratio * ratio) * Eigen::Vector3d(track, track, disparity);
  }
};

/// A landmark. `coordinates` are (x/z, y/z, 1/z) in a fixed reference camera. They are not singular
/// at infinity, so far points need no special treatment. The error of the inverse depth is
/// symmetric and does not bias the motion; that of the depth would.
struct InverseDepthPoint {
  Eigen::Isometry3d T_world_reference = Eigen::Isometry3d::Identity();
  Eigen::Vector3d coordinates = Eigen::Vector3d::Zero();
};

/// Derivatives of a StereoPixel.
struct ProjectionJacobians {
  Eigen::Matrix<double, 3, 6> pose;  ///< with respect to d in T_world_camera * expSe3(d)
  Eigen::Matrix3d point;             ///< with respect to the point's coordinates
};

/// The point's position in the camera times its inverse depth in the reference.
Eigen::Vector3d scaledCameraPoint(const Eigen::Isometry3d& T_world_camera,
                                  const InverseDepthPoint& point);

/// Empty for a point that is not in front of the camera. `jacobians` may be null.
std::optional<StereoPixel> project(const CameraRig& rig, const Eigen::Isometry3d& T_world_camera,
                                   const InverseDepthPoint& point,
                                   ProjectionJacobians* jacobians = nullptr);

/// The inverse of project() at the reference itself.
Eigen::Vector3d triangulate(const CameraRig& rig, const StereoPixel& pixel);

/// Covariance of triangulate(): linear in inverse depth, hence exact.
Eigen::Matrix3d triangulationCovariance(const CameraRig& rig, const Eigen::Vector3d& sigma);

// The stereo projection of four points at once, with its derivatives (projection.hpp is the same
// for one point).

struct LaneCamera {
  double fx;
  double fy;
  double cx;
  double cy;
  double fb;  ///< fx times the baseline

  explicit LaneCamera(const CameraRig& rig)
      : fx(rig.pinhole.fx),
        fy(rig.pinhole.fy),
        cx(rig.pinhole.cx),
        cy(rig.pinhole.cy),
        fb(rig.pinhole.fx * rig.baseline) {}
};

/// Reference cameras of four points; `axis` is the optical one.
struct LaneReference {
  Four3 by_x = {};
  Four3 by_y = {};
  Four3 axis = {};
  Four3 origin = {};

  void set(std::size_t lane, const Eigen::Isometry3d& T) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      by_x[i][lane] = T.linear()(row, 0);
      by_y[i][lane] = T.linear()(row, 1);
      axis[i][lane] = T.linear()(row, 2);
      origin[i][lane] = T.translation()(row);
    }
  }
};

/// Positions in the world times the inverse depth in the reference.
TOLMAN_INLINE Four3 scaledPosition(const LaneReference& reference, const Four3& coordinates) {
  Four3 m;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i] = reference.axis[i] + coordinates[0] * reference.by_x[i] +
           coordinates[1] * reference.by_y[i] + coordinates[2] * reference.origin[i];
  }
  return m;
}

struct alignas(32) LaneProjection {
  FourMask front;    ///< whether the point is in front of the camera; all else is 0 if not
  Four3 q;           ///< position in the camera times the inverse depth in the reference
  Four inverse;      ///< 1 / q.z
  Four3 fromCentre;  ///< pixel relative to the principal point, and disparity
};

TOLMAN_INLINE LaneProjection projected(const LaneCamera& camera, const PlainPose& pose,
                                       const Four3& scaled, Four inverse_depth) {
  LaneProjection p;
  const Four3 world = {scaled[0] - inverse_depth * pose.t[0], scaled[1] - inverse_depth * pose.t[1],
                       scaled[2] - inverse_depth * pose.t[2]};
  p.q = turnedBack(pose, world);
  p.front = p.q[2] >= 1e-3;  // the same as in project()
  p.inverse = select(p.front, 1.0 / p.q[2], Four{});
  p.fromCentre = {camera.fx * p.q[0] * p.inverse, camera.fy * p.q[1] * p.inverse,
                  camera.fb * inverse_depth * p.inverse};
  return p;
}

using LaneByPoint = std::array<Four3, 3>;
using LaneByPose = std::array<Four6, 3>;

/// Rows: u, v, disparity; columns: coordinates of the point.
TOLMAN_INLINE LaneByPoint derivativesByPoint(const LaneCamera& camera, const PlainPose& pose,
                                             const LaneReference& reference,
                                             const LaneProjection& p) {
  const Four3 away = {reference.origin[0] - pose.t[0], reference.origin[1] - pose.t[1],
                      reference.origin[2] - pose.t[2]};
  const std::array<Four3, 3> columns = {turnedBack(pose, reference.by_x),
                                        turnedBack(pose, reference.by_y), turnedBack(pose, away)};
  LaneByPoint J;
  for (std::size_t i = 0; i < 3; ++i) {
    J[0][i] = p.inverse * (camera.fx * columns[i][0] - p.fromCentre[0] * columns[i][2]);
    J[1][i] = p.inverse * (camera.fy * columns[i][1] - p.fromCentre[1] * columns[i][2]);
    J[2][i] = -p.inverse * p.fromCentre[2] * columns[i][2];
  }
  J[2][2] += camera.fb * p.inverse;
  return J;
}

/// By noise in T_world_camera * expSe3(noise).
TOLMAN_INLINE LaneByPose derivativesByPose(const LaneCamera& camera, const LaneProjection& p,
                                           Four inverse_depth) {
  const Four a = camera.fx * p.inverse;
  const Four b = camera.fy * p.inverse;
  const Four3 c = {-p.fromCentre[0] * p.inverse, -p.fromCentre[1] * p.inverse,
                   -p.fromCentre[2] * p.inverse};
  const Four zero = {};
  LaneByPose J;
  J[0] = {-inverse_depth * a,         zero,      -inverse_depth * c[0], -c[0] * p.q[1],
          c[0] * p.q[0] - a * p.q[2], a * p.q[1]};
  J[1] = {zero,          -inverse_depth * b, -inverse_depth * c[1], b * p.q[2] - c[1] * p.q[1],
          c[1] * p.q[0], -b * p.q[0]};
  J[2] = {zero, zero, -inverse_depth * c[2], -c[2] * p.q[1], c[2] * p.q[0], zero};
  return J;
}

}  // namespace tolman::feature_stereo
