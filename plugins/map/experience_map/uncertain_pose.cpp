// SPDX-License-Identifier: BSD-3-Clause
// Propagation of covariance by the adjoint.
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

UncertainPose compose(const UncertainPose& a, const UncertainPose& b) {
  const Matrix6d ad = adjointSe3(b.T.inverse());
  return {a.T * b.T, ad * a.covariance * ad.transpose() + b.covariance};
}

UncertainPose inverse(const UncertainPose& a) {
  const Matrix6d ad = adjointSe3(a.T);
  return {a.T.inverse(), ad * a.covariance * ad.transpose()};
}

Matrix6d isotropic(double sigma_translation, double sigma_rotation) {
  Vector6d variances;
  variances.head<3>().setConstant(sigma_translation * sigma_translation);
  variances.tail<3>().setConstant(sigma_rotation * sigma_rotation);
  return variances.asDiagonal();
}

Eigen::Matrix<double, 3, 6> planarProjection(const Eigen::Matrix3d& R_world_camera, double theta) {
  const Eigen::Matrix3d R_level_camera =
      fromPlanar({0, 0, theta}).linear().transpose() * R_world_camera;
  Eigen::Matrix<double, 3, 6> project = Eigen::Matrix<double, 3, 6>::Zero();
  project.row(0).head<3>() = R_level_camera.row(2);   // forward is z
  project.row(1).head<3>() = -R_level_camera.row(0);  // left is -x
  project.row(2).tail<3>() = -R_level_camera.row(1);  // counter-clockwise is about -y
  return project;
}

}  // namespace tolman::experience_map
