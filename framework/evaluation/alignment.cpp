// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/alignment.hpp"

#include <Eigen/SVD>
#include <cmath>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

// Singular values below this share of the largest are rounding errors.
constexpr double kRankTolerance = 1e-10;

/// Rotation between the orientations of the first pair, used where the positions do not move.
Eigen::Matrix3d firstRotation(const Matches& matches) {
  return matches.truth.front().T_world_camera.linear() *
         matches.estimate.front().T_world_camera.linear().transpose();
}

/// The smallest rotation from unit vector `a` to `b`. (Eigen's own function takes ten seconds to
/// compile.)
Eigen::Matrix3d shortestTurn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double cosine = a.dot(b);
  if (cosine < -1 + 1e-12) {  // half a turn about any orthogonal axis
    const Eigen::Vector3d axis = a.unitOrthogonal();
    return 2 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector3d cross = a.cross(b);
  return Eigen::Quaterniond(1 + cosine, cross.x(), cross.y(), cross.z())
      .normalized()
      .toRotationMatrix();
}

/// Umeyama, equations 38-43; `covariance` is truth times estimate transposed.
struct Umeyama {
  Eigen::Matrix3d R;
  double trace;  ///< trace(D S), the numerator of the scale
};

Umeyama umeyama(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& fallback) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d& d = svd.singularValues();
  if (!(d[0] > 0)) return {fallback, 0};
  if (d[1] <= kRankTolerance * d[0]) {  // a line: the rotation about it is undetermined
    return {shortestTurn(svd.matrixV().col(0), svd.matrixU().col(0)), d[0]};
  }
  Eigen::Vector3d s = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) s[2] = -1;  // no reflection
  return {svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose(), d.dot(s)};
}

/// The best rotation about the vertical axis (camera y), in closed form.
Eigen::Matrix3d planarRotation(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& fallback) {
  const double cosine = covariance(0, 0) + covariance(2, 2);
  const double sine = covariance(0, 2) - covariance(2, 0);
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = fallback;
  const bool open = std::hypot(cosine, sine) <= 0;
  const double angle = open ? -toPlanar(turn).theta : std::atan2(sine, cosine);
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

}  // namespace

Eigen::Isometry3d Similarity::apply(const Eigen::Isometry3d& T_world_camera) const {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R * T_world_camera.linear();
  T.translation() = scale * (R * T_world_camera.translation()) + t;
  return T;
}

Result<Similarity> align(const Matches& matches, Alignment alignment) {
  Similarity similarity;
  if (alignment == Alignment::None) return similarity;
  const Eigen::Matrix3Xd truth = positions(matches.truth);
  const Eigen::Matrix3Xd estimate = positions(matches.estimate);
  const Eigen::Vector3d truth_mean = truth.rowwise().mean();
  const Eigen::Vector3d estimate_mean = estimate.rowwise().mean();
  const Eigen::Matrix3Xd centred = estimate.colwise() - estimate_mean;
  const Eigen::Matrix3d covariance = (truth.colwise() - truth_mean) * centred.transpose();

  if (alignment == Alignment::Se2) {
    similarity.R = planarRotation(covariance, firstRotation(matches));
  } else {
    const Umeyama fit = umeyama(covariance, firstRotation(matches));
    similarity.R = fit.R;
    if (alignment == Alignment::Sim3) similarity.scale = fit.trace / centred.squaredNorm();
    if (!std::isfinite(similarity.scale) || similarity.scale < 1e-12) {
      return Status::invalidInput("no scale can be found: truth or estimate does not move");
    }
  }
  similarity.t = truth_mean - similarity.scale * (similarity.R * estimate_mean);
  if (alignment == Alignment::Se2) similarity.t.y() = 0;
  return similarity;
}

Matches aligned(const Matches& matches, const Similarity& similarity) {
  Matches result = matches;
  for (TrajectoryPose& pose : result.estimate) {
    pose.T_world_camera = similarity.apply(pose.T_world_camera);
  }
  return result;
}

}  // namespace tolman::evaluation
