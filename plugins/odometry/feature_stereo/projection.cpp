// SPDX-License-Identifier: BSD-3-Clause
// Stereo projection of inverse depth points with its derivatives.
#include "projection.hpp"

namespace tolman::feature_stereo {

Eigen::Vector3d scaledCameraPoint(const Eigen::Isometry3d& T_world_camera,
                                  const InverseDepthPoint& point) {
  const Eigen::Vector3d ray(point.coordinates.x(), point.coordinates.y(), 1);
  const Eigen::Vector3d offset =
      point.T_world_reference.translation() - T_world_camera.translation();
  return T_world_camera.linear().transpose() *
         (point.T_world_reference.linear() * ray + point.coordinates.z() * offset);
}

std::optional<StereoPixel> project(const CameraRig& rig, const Eigen::Isometry3d& T_world_camera,
                                   const InverseDepthPoint& point, ProjectionJacobians* jacobians) {
  constexpr double kNearPlane = 1e-3;  // of the depth in the reference; keeps the division finite
  const Eigen::Vector3d q = scaledCameraPoint(T_world_camera, point);
  if (q.z() < kNearPlane) return std::nullopt;
  const Pinhole& pinhole = rig.pinhole;
  const double inverse_z = 1 / q.z();
  const double rho = point.coordinates.z();
  const double fb = pinhole.fx * rig.baseline;
  const double x = pinhole.fx * q.x() * inverse_z;
  const double y = pinhole.fy * q.y() * inverse_z;
  const double d = fb * rho * inverse_z;
  if (jacobians != nullptr) {
    Eigen::Matrix3d by_q;
    by_q << pinhole.fx * inverse_z, 0, -x * inverse_z,  //
        0, pinhole.fy * inverse_z, -y * inverse_z,      //
        0, 0, -d * inverse_z;
    const Eigen::Matrix3d R_camera_world = T_world_camera.linear().transpose();
    jacobians->pose.leftCols<3>() = -rho * by_q;
    jacobians->pose.rightCols<3>() = by_q * skew(q);
    Eigen::Matrix3d q_by_point;
    q_by_point.leftCols<2>() = R_camera_world * point.T_world_reference.linear().leftCols<2>();
    q_by_point.col(2) =
        R_camera_world * (point.T_world_reference.translation() - T_world_camera.translation());
    jacobians->point = by_q * q_by_point;
    jacobians->point(2, 2) += fb * inverse_z;
  }
  return StereoPixel(x + pinhole.cx, y + pinhole.cy, d);
}

Eigen::Vector3d triangulate(const CameraRig& rig, const StereoPixel& pixel) {
  const Pinhole& pinhole = rig.pinhole;
  return {(pixel.x() - pinhole.cx) / pinhole.fx, (pixel.y() - pinhole.cy) / pinhole.fy,
          pixel.z() / (pinhole.fx * rig.baseline)};
}

Eigen::Matrix3d triangulationCovariance(const CameraRig& rig, const Eigen::Vector3d& sigma) {
  const Pinhole& pinhole = rig.pinhole;
  const Eigen::Vector3d scale(pinhole.fx, pinhole.fy, pinhole.fx * rig.baseline);
  return sigma.cwiseQuotient(scale).cwiseAbs2().asDiagonal();
}

}  // namespace tolman::feature_stereo
