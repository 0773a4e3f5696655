// SPDX-License-Identifier: BSD-3-Clause
// Residual and derivatives of a planar link.
#include "planar_link.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace tolman::experience_map {
namespace {

using RowMatrix3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Map<RowMatrix3d> matrixAt(double* numbers) { return Eigen::Map<RowMatrix3d>{numbers}; }

bool identityJacobian(double* jacobian) {
  matrixAt(jacobian).setIdentity();
  return true;
}

}  // namespace

bool PlanarManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  x_plus_delta[0] = x[0] + delta[0];
  x_plus_delta[1] = x[1] + delta[1];
  x_plus_delta[2] = wrapAngle(x[2] + delta[2]);
  return true;
}

bool PlanarManifold::PlusJacobian(const double* /*x*/, double* jacobian) const {
  return identityJacobian(jacobian);
}

bool PlanarManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  y_minus_x[0] = y[0] - x[0];
  y_minus_x[1] = y[1] - x[1];
  y_minus_x[2] = wrapAngle(y[2] - x[2]);
  return true;
}

bool PlanarManifold::MinusJacobian(const double* /*x*/, double* jacobian) const {
  return identityJacobian(jacobian);
}

bool PlanarLinkCost::Evaluate(double const* const* nodes, double* residuals,
                              double** jacobians) const {
  const double* i = nodes[0];
  const double* j = nodes[1];
  const PlanarPose seen = between({i[0], i[1], i[2]}, {j[0], j[1], j[2]});
  const Eigen::Vector3d error(seen.x - link_.x, seen.y - link_.y,
                              wrapAngle(seen.theta - link_.theta));
  Eigen::Map<Eigen::Vector3d>{residuals} = whitening_ * error;
  if (jacobians == nullptr) return true;

  const double c = std::cos(i[2]);
  const double s = std::sin(i[2]);
  Eigen::Matrix3d by_j;
  by_j << c, s, 0, -s, c, 0, 0, 0, 1;
  Eigen::Matrix3d by_i = -by_j;
  by_i.block<2, 1>(0, 2) << seen.y, -seen.x;
  if (jacobians[0] != nullptr) matrixAt(jacobians[0]) = whitening_ * by_i;
  if (jacobians[1] != nullptr) matrixAt(jacobians[1]) = whitening_ * by_j;
  return true;
}

Eigen::Matrix3d whiteningOf(const Eigen::Matrix3d& covariance) {
  constexpr double kLeastVariance = 1e-12;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  const Eigen::Vector3d scale =
      eigen.eigenvalues().cwiseMax(kLeastVariance).cwiseSqrt().cwiseInverse();
  return eigen.eigenvectors() * scale.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace tolman::experience_map
