// SPDX-License-Identifier: BSD-3-Clause
// Links between poses, in the plane and in space: what the optimisers know of a geometry G.
#pragma once

#include <cstddef>
#include <tolman/geometry.hpp>

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
  double weight = 1;   ///< weight that the robust loss leaves it, in [0, 1]
};
using PlanarLink = PoseLink<Plane>;
using SpatialLink = PoseLink<Space>;

/// Derivatives of a link's residual by the steps of its ends.
template <class G>
struct LinkDerivatives {
  MatrixOf<G> by_from;
  MatrixOf<G> by_to;
};

/// Inverse of a covariance. 1e-12 is added to the variances, so that a singular one has an inverse.
template <int kSize>
Eigen::Matrix<double, kSize, kSize> informationOf(
    const Eigen::Matrix<double, kSize, kSize>& covariance) {
  constexpr double kLeastVariance = 1e-12;
  return (covariance + kLeastVariance * Eigen::Matrix<double, kSize, kSize>::Identity()).inverse();
}

}  // namespace tolman::experience_map
