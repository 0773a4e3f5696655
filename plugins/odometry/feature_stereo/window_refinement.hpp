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
  double offset_sigma = 0.2;   ///< px, of the disparity offset before anything is known
  double offset_drift = 0.01;  ///< px, how far it may go with one keyframe
};

/// Stereo reprojection error of one observation, in standard deviations. Blocks: pose, coordinates
/// of the point, disparity offset.
///
/// The pose block is (x, y, z, qx, qy, qz, qw). Its derivatives are by the tangent of PoseManifold
/// and stand in the first six columns; the seventh is zero. PoseManifold's PlusJacobian passes them
/// through, so nothing is multiplied out and divided back again.
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

/// Holds the disparity offset near zero and near what it was: while the camera stands nothing else
/// tells it from a change of scale.
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

/// Moves keyframes (but the oldest, which holds the world still) and landmarks to where the
/// observations fit best, with the disparity offset among the unknowns, then removes observations
/// that do not fit and updates the landmarks' covariances. Single-threaded and free of addresses:
/// the same window gives the same bits.
void refineWindow(const CameraRig& rig, const RefinementSettings& settings, Window& window);

}  // namespace tolman::feature_stereo
