// SPDX-License-Identifier: BSD-3-Clause
// The paper's residual of one link between two planar nodes, and the space the nodes live in.
#pragma once

#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

#include <tolman/geometry.hpp>

namespace tolman::experience_map {

/// A node is the block (x m, y m, theta rad); theta stays in [-pi, pi) (paper, "s.t.").
class PlanarManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 3; }
  int TangentSize() const override { return 3; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

/// f(e_i, e_j, e_ij) of the paper's section Cognitive Map,
///
///   x_j - x_i - d cos(theta_i + heading)
///   y_j - y_i - d sin(theta_i + heading)
///   theta_j - theta_i - facing            (wrapped)
///
/// turned by -theta_i, so that it is seen along the axes of e_i in which the covariance is known,
/// and whitened. Where the noise is isotropic the turn does not change its length.
class PlanarLinkCost final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  /// `link` is e_j seen from e_i: d and heading are its polar form, facing its theta.
  PlanarLinkCost(const PlanarPose& link, const Eigen::Matrix3d& whitening)
      : link_(link), whitening_(whitening) {}
  bool Evaluate(double const* const* nodes, double* residuals, double** jacobians) const override;

 private:
  PlanarPose link_;
  Eigen::Matrix3d whitening_;
};

/// The symmetric W with W * covariance * W == identity. Standard deviations below 1e-6 count as
/// 1e-6, so that a degenerate covariance cannot divide by zero.
Eigen::Matrix3d whiteningOf(const Eigen::Matrix3d& covariance);

}  // namespace tolman::experience_map
