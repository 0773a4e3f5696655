// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/alignment.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

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

/// The best rotation about an axis, in closed form: the one with the largest trace of R'
/// covariance.
Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& axis, const Eigen::Matrix3d& covariance,
                              const Eigen::Matrix3d& fallback) {
  const auto angle = [&](const Eigen::Matrix3d& m) {
    const Eigen::Vector3d twist(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    const double sine = axis.dot(twist), cosine = m.trace() - axis.dot(m * axis);
    return std::hypot(cosine, sine) > 0 ? std::optional(std::atan2(sine, cosine)) : std::nullopt;
  };
  const auto found = angle(covariance);
  return Eigen::AngleAxisd(found ? *found : angle(fallback).value_or(0), axis).toRotationMatrix();
}

/// The pairs centred on a point of each: its mean, or for Origin its first pose.
struct Centred {
  Centred(const Matches& matches, std::size_t count, bool at_first)
      : truth(positions(matches.truth).leftCols(static_cast<Eigen::Index>(count))),
        estimate(positions(matches.estimate).leftCols(static_cast<Eigen::Index>(count))) {
    truth_centre = at_first ? Eigen::Vector3d(truth.col(0)) : truth.rowwise().mean();
    estimate_centre = at_first ? Eigen::Vector3d(estimate.col(0)) : estimate.rowwise().mean();
    truth.colwise() -= truth_centre;
    estimate.colwise() -= estimate_centre;
  }
  Eigen::Matrix3d covariance() const { return truth * estimate.transpose(); }

  Eigen::Matrix3Xd truth;
  Eigen::Matrix3Xd estimate;
  Eigen::Vector3d truth_centre;
  Eigen::Vector3d estimate_centre;
};

}  // namespace

Eigen::Isometry3d Similarity::apply(const Eigen::Isometry3d& T_world_camera) const {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R * T_world_camera.linear();
  T.translation() = scale * (R * T_world_camera.translation()) + t;
  return T;
}

Result<Similarity> align(const Matches& matches, const AlignmentRule& rule) {
  const bool fits = rule.kind == Alignment::Sim3 || rule.scale == ScaleRule::Fit;
  const std::size_t count = rule.first > 0 ? std::min(rule.first, matches.size()) : matches.size();
  const Eigen::Matrix3d first = firstRotation(matches);
  const Centred about_mean(matches, count, false);
  const Umeyama best = umeyama(about_mean.covariance(), first);
  Centred points = rule.kind == Alignment::Origin ? Centred(matches, count, true) : about_mean;
  Similarity similarity;
  if (rule.kind == Alignment::None) {
    points.truth.colwise() += points.truth_centre;
    points.estimate.colwise() += points.estimate_centre;
    points.truth_centre = points.estimate_centre = Eigen::Vector3d::Zero();
  } else if (rule.kind == Alignment::Origin) {
    similarity.R = first;
  } else if (rule.kind == Alignment::Se3 || rule.kind == Alignment::Sim3) {
    similarity.R = best.R;
  } else {
    similarity.R = rotationAbout(rule.vertical, points.covariance(), first);
  }
  if (fits) {
    const double products = similarity.R.cwiseProduct(points.covariance()).sum();
    similarity.scale = products / points.estimate.squaredNorm();
  } else if (rule.scale == ScaleRule::Sim3) {
    similarity.scale = best.trace / about_mean.estimate.squaredNorm();
  }
  if (!std::isfinite(similarity.scale) || similarity.scale < 1e-12) {
    return Status::invalidInput("no scale can be found: truth or estimate does not move");
  }
  similarity.t = points.truth_centre - similarity.scale * (similarity.R * points.estimate_centre);
  if (rule.kind == Alignment::Se2) similarity.t.y() = 0;
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
