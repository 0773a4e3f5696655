// SPDX-License-Identifier: BSD-3-Clause
// Links between poses, and the two geometries G of the optimisers: the plane and space.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <tolman/geometry.hpp>
#include <vector>

#include "block_cholesky.hpp"

namespace tolman::experience_map {

/// Poses (x m, y m, theta rad) of the paper. A step is added to the coordinates.
struct Plane {
  static constexpr int kSize = 3;
  using Pose = PlanarPose;
  static Pose identity() { return {}; }
};

/// Rigid motions. A step d of a node is T * expSe3(d), so nothing depends on the world frame.
struct Space {
  static constexpr int kSize = 6;
  using Pose = Eigen::Isometry3d;
  static Pose identity() { return Eigen::Isometry3d::Identity(); }
};

template <class G>
using StepOf = Eigen::Matrix<double, G::kSize, 1>;
template <class G>
using MatrixOf = Eigen::Matrix<double, G::kSize, G::kSize>;

template <class G>
struct PoseLink {
  std::size_t from = 0;
  std::size_t to = 0;
  typename G::Pose pose = G::identity();  ///< of `to`, relative to `from`
  /// Plane: along the axes of `from`. Space: in the tangent space of `to`, as in the records.
  MatrixOf<G> covariance = MatrixOf<G>::Zero();
  bool robust = true;  ///< under the robust loss; otherwise plain least squares
  double weight = 1;   ///< from the robust loss, in [0, 1]
};
using PlanarLink = PoseLink<Plane>;
using SpatialLink = PoseLink<Space>;

/// The weights of all links, the only values of links that an optimisation changes.
template <class G>
std::vector<double> weightsOf(const std::vector<PoseLink<G>>& links) {
  std::vector<double> weights;
  weights.reserve(links.size());
  for (const PoseLink<G>& link : links) weights.push_back(link.weight);
  return weights;
}
template <class G>
void setWeights(std::vector<PoseLink<G>>& links, const std::vector<double>& weights) {
  for (std::size_t k = 0; k < links.size(); ++k) links[k].weight = weights[k];
}

/// A link's residual and its derivatives with respect to the steps of its ends.
template <class G>
struct LinkDerivatives {
  StepOf<G> residual;
  MatrixOf<G> by_from;
  MatrixOf<G> by_to;
};

/// Inverse of a covariance, and the logarithm of its determinant. 1e-12 is added to the variances,
/// so that a singular one has an inverse.
template <int kSize>
Eigen::Matrix<double, kSize, kSize> informationOf(
    const Eigen::Matrix<double, kSize, kSize>& covariance, double& log_determinant) {
  constexpr double kMinVariance = 1e-12;
  using Block = Eigen::Matrix<double, kSize, kSize>;
  const Block regular = covariance + kMinVariance * Block::Identity();
  Block information = regular;
  double log_variance = 0;
  if (invertPositive(information, log_variance)) {
    log_determinant = -log_variance;
  } else {  // not positive definite by rounding
    information = regular.inverse();
    log_determinant = std::log(std::abs(information.determinant()));
  }
  return information;
}

template <int kSize>
Eigen::Matrix<double, kSize, kSize> informationOf(
    const Eigen::Matrix<double, kSize, kSize>& covariance) {
  double unused = 0;
  return informationOf(covariance, unused);
}

// Residual of a link between two planar poses (paper, section "Cognitive Map") and its derivatives.
// Lengths are metres, angles radians.

/// f(e_i, e_j, e_ij) of the paper's section Cognitive Map,
///
///   x_j - x_i - d cos(theta_i + heading)
///   y_j - y_i - d sin(theta_i + heading)
///   theta_j - theta_i - facing            (wrapped)
///
/// rotated by -theta_i into the axes of e_i, in which the covariance is given. If the noise is
/// isotropic, this rotation does not change the length of the residual. The link's pose is that of
/// e_j relative to e_i: d and heading are its polar form, facing is its theta.
Eigen::Vector3d residualOf(const PlanarLink& link, const PlanarPose& from, const PlanarPose& to);

/// Its derivatives with respect to (x, y, theta) of both ends.
LinkDerivatives<Plane> derivativesOf(const PlanarLink& link, const PlanarPose& from,
                                     const PlanarPose& to);

/// The pose after a step (m, m, rad).
PlanarPose moved(const PlanarPose& pose, const Eigen::Vector3d& step);

// Residual of a link between two poses in space and its derivatives.

/// r = log((T_i e_ij)^-1 T_j): the motion from where the link expects `to` to where it is, as a
/// twist (m, rad) in the tangent space in which the covariance is given. It does not depend on the
/// world frame.
Vector6d residualOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                    const Eigen::Isometry3d& to);

/// dr/d_to = J(r), dr/d_from = -J(r) Ad(T_j^-1 T_i), J: the inverse right Jacobian of SE(3).
LinkDerivatives<Space> derivativesOf(const SpatialLink& link, const Eigen::Isometry3d& from,
                                     const Eigen::Isometry3d& to);

/// a followed by b, the counterpart of compose() for planar poses.
inline Eigen::Isometry3d compose(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return a * b;
}
inline Eigen::Isometry3d between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return a.inverse() * b;
}

/// T * expSe3(step).
Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& step);

}  // namespace tolman::experience_map
