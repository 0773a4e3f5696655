// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/motion_consistency.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <optional>
#include <utility>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

constexpr double kInside99 = 16.812;        // 99 % quantile of chi-squared, six degrees of freedom
constexpr double kInside99Planar = 11.345;  // three
constexpr std::array kInPlane = {0, 2, 4};  // of a twist: right, forward, turn about the vertical

/// error' covariance^-1 error; none where the covariance is not positive definite.
std::optional<double> normalisedSquare(const Eigen::VectorXd& error, const Eigen::MatrixXd& cov) {
  const Eigen::LLT<Eigen::MatrixXd> cholesky(cov);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  return cholesky.matrixL().solve(error).squaredNorm();
}

}  // namespace

MotionErrors::MotionErrors(const Trajectory& truth, bool planar)
    : truth_(truth), planar_(planar), next_(truth.begin()) {
  if (planar) sums_.degrees_of_freedom = 3;
}

void MotionErrors::add(const Motion& motion) {
  while (next_ != truth_.end() && next_->frame < motion.frame) ++next_;
  const bool known = next_ != truth_.end() && next_->frame == motion.frame;
  const TrajectoryPose* now = known ? &*next_ : nullptr;
  const TrajectoryPose* before = std::exchange(before_, now);
  if (motion.state != TrackingState::Tracking || !motion.scale_known || !now || !before) return;
  const Eigen::Isometry3d true_motion = before->T_world_camera.inverse() * now->T_world_camera;
  const Vector6d error = logSe3(motion.T_previous_current.inverse() * true_motion);
  const auto square = planar_
                          ? normalisedSquare(error(kInPlane), motion.covariance(kInPlane, kInPlane))
                          : normalisedSquare(error, motion.covariance);
  ++sums_.motions;
  if (!square) {
    ++sums_.without_covariance;
    return;
  }
  sums_.mean += *square;
  if (*square < (planar_ ? kInside99Planar : kInside99)) ++sums_.share_99;
}

MotionConsistency MotionErrors::result() const {
  MotionConsistency result = sums_;
  const std::size_t with = sums_.motions - sums_.without_covariance;
  if (with > 0) result.mean /= static_cast<double>(with);
  if (sums_.motions > 0) result.share_99 /= static_cast<double>(sums_.motions);
  return result;
}

nlohmann::ordered_json toJson(const MotionConsistency& c) {
  using Json = nlohmann::ordered_json;
  const bool known = c.motions > 0;
  return {{"mean", c.motions > c.without_covariance ? Json(c.mean) : Json()},
          {"degrees_of_freedom", c.degrees_of_freedom},
          {"share_within_99", known ? Json(c.share_99) : Json()},
          {"motions", c.motions},
          {"without_covariance", c.without_covariance},
          {"reason", known ? Json() : Json("no tracked motion in metres between two true poses")}};
}

}  // namespace tolman::evaluation
