// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment of the active window with Ceres.
#pragma once

#include <ceres/manifold.h>
#include <ceres/sized_cost_function.h>

#include "window.hpp"

namespace tolman::feature_stereo {

struct RefinementSettings {
  PixelNoise noise;
  int iterations = 6;
  double offset_sigma = 0.2;  ///< px, prior standard deviation of the disparity offset
  /// px, standard deviation of its change per keyframe; chosen, not tuned
  double offset_drift = 0.01;
};

/// Stereo reprojection error of one observation, in standard deviations. Blocks: pose, coordinates
/// of the point, disparity offset.
///
/// The pose block is (x, y, z, qx, qy, qz, qw). Its derivatives are by the tangent of PoseManifold
/// and are in the first six columns; the seventh is zero. PoseManifold's PlusJacobian leaves them
/// unchanged, which saves a product with the Jacobian of the quaternion.
class StereoReprojection final : public ceres::SizedCostFunction<3, 7, 3, 1> {
 public:
  StereoReprojection(const CameraRig& rig, const Eigen::Isometry3d& T_world_reference,
                     const Observation& observation, const RefinementSettings& settings);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const CameraRig& rig_;
  Eigen::Isometry3d T_world_reference_;
  StereoPixel pixel_;
  Eigen::Vector3d weights_;  ///< 1 / sigma; 0 for a disparity that was not measured
};

/// Prior of the disparity offset: near zero and near its last value. While the camera stands, no
/// observation distinguishes the offset from a change of scale.
class OffsetPrior final : public ceres::SizedCostFunction<2, 1> {
 public:
  OffsetPrior(double before, const RefinementSettings& settings)
      : before_(before), sigma_(settings.offset_sigma), drift_(settings.offset_drift) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  double before_;
  double sigma_;
  double drift_;
};

/// T * expSe3(delta), with the Jacobian that StereoReprojection expects.
class PoseManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 6; }
  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override;
  bool PlusJacobian(const double* x, double* jacobian) const override;
  bool Minus(const double* y, const double* x, double* y_minus_x) const override;
  bool MinusJacobian(const double* x, double* jacobian) const override;
};

using PoseBlock = Eigen::Matrix<double, 7, 1>;
PoseBlock toBlock(const Eigen::Isometry3d& T);
Eigen::Isometry3d fromBlock(const double* block);

/// Minimises the reprojection errors over keyframe poses (the oldest is fixed), landmarks and the
/// disparity offset, then removes outlying observations and updates the covariances of landmarks.
/// Single-threaded, with blocks in a fixed order: the same window gives the same bits.
void refineWindow(const CameraRig& rig, const RefinementSettings& settings, Window& window);

}  // namespace tolman::feature_stereo
