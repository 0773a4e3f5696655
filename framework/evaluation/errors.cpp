// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/errors.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

/// Collects the errors of single steps.
class StepErrors {
 public:
  void add(const Matches& matches, std::size_t from, std::size_t to, double divisor) {
    const Eigen::Isometry3d truth = motion(matches.truth, from, to);
    const Eigen::Isometry3d error = truth.inverse() * motion(matches.estimate, from, to);
    translations_.push_back(error.translation().norm() / divisor);
    rotations_.push_back(logSo3(error.linear()).norm() * 180 / std::numbers::pi / divisor);
  }
  RelativeError result() && {
    return {statistics(std::move(translations_)), statistics(std::move(rotations_))};
  }

 private:
  static Eigen::Isometry3d motion(const Trajectory& trajectory, std::size_t from, std::size_t to) {
    return trajectory[from].T_world_camera.inverse() * trajectory[to].T_world_camera;
  }
  std::vector<double> translations_;
  std::vector<double> rotations_;
};

constexpr std::size_t kStartEvery = 10;
constexpr double kLongestOvershoot = 0.1;  // of a segment's length

/// The length that the errors of a segment are divided by. It is the nominal length, as in KITTI's
/// program, if the segment ends at the first true pose beyond it; the true length, if true poses
/// before that end have no estimate. None if that makes the segment too long, if it ends in another
/// piece of the path, or if its true length is more than twice the nominal one, because frames are
/// far apart.
std::optional<double> lengthOf(const Matches& matches, std::size_t from, std::size_t to,
                               double nominal) {
  if (!matches.inOnePiece(from, to)) return std::nullopt;
  const double driven = matches.driven[to] - matches.driven[from];
  if (driven > 2 * nominal) return std::nullopt;
  if (matches.index[to] == matches.index[to - 1] + 1) return nominal;
  if (driven > (1 + kLongestOvershoot) * nominal) return std::nullopt;
  return driven;
}

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

Statistics statistics(std::vector<double> values) {
  Statistics result;
  result.count = values.size();
  if (values.empty()) return result;
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  for (const double value : values) {
    result.mean += value / count;
    result.rmse += value * value / count;
  }
  result.rmse = std::sqrt(result.rmse);
  const std::size_t middle = values.size() / 2;
  result.median =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  result.min = values.front();
  result.max = values.back();
  return result;
}

std::vector<double> positionErrors(const Matches& aligned, Direction direction) {
  std::vector<double> values;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    Eigen::Vector3d error = aligned.estimate[i].T_world_camera.translation() -
                            aligned.truth[i].T_world_camera.translation();
    if (direction == Direction::Horizontal) error.y() = 0;
    if (direction == Direction::Vertical) error.x() = error.z() = 0;
    values.push_back(error.norm());
  }
  return values;
}

Statistics absoluteError(const Matches& aligned, Direction direction) {
  return statistics(positionErrors(aligned, direction));
}

RelativeError relativeErrorOverFrames(const Matches& aligned, std::int64_t delta) {
  StepErrors errors;
  std::size_t to = 0;
  for (std::size_t from = 0; from < aligned.size(); ++from) {
    const std::int64_t wanted = aligned.estimate[from].frame + delta;
    while (to < aligned.size() && aligned.estimate[to].frame < wanted) ++to;
    if (to == aligned.size()) break;
    if (aligned.estimate[to].frame == wanted && aligned.inOnePiece(from, to)) {
      errors.add(aligned, from, to, 1);
    }
  }
  return std::move(errors).result();
}

RelativeError relativeErrorOverDistance(const Matches& aligned, double length) {
  StepErrors errors;
  const std::vector<double>& distance = aligned.driven;
  std::size_t to = 0;
  for (std::size_t from = 0; from < aligned.size(); ++from) {
    while (to < aligned.size() && distance[to] - distance[from] < length) ++to;
    if (to == aligned.size()) break;
    if (!aligned.inOnePiece(from, to)) continue;
    errors.add(aligned, from, to, distance[to] - distance[from]);
  }
  return std::move(errors).result();
}

SegmentLengths kittiLengths() { return {"kitti", {100, 200, 300, 400, 500, 600, 700, 800}}; }

SegmentLengths shortLengths() { return {"short", {5, 10, 20, 30, 40, 50}}; }

SegmentLengths lengthsFor(double truth_path_length_m) {
  return truth_path_length_m >= 200 ? kittiLengths() : shortLengths();
}

SegmentErrors segmentErrors(const Matches& matches, const SegmentLengths& lengths) {
  SegmentErrors result;
  result.lengths = lengths;
  double translation = 0;  // sum of errors, m per m
  double rotation = 0;     // rad/m
  const std::vector<double>& distance = matches.driven;
  for (std::size_t from = 0; from < matches.size(); from += kStartEvery) {
    for (const double nominal : lengths.lengths_m) {
      const auto end = std::upper_bound(distance.begin(), distance.end(), distance[from] + nominal);
      if (end == distance.end()) continue;
      const auto to = static_cast<std::size_t>(end - distance.begin());
      const auto length = lengthOf(matches, from, to, nominal);
      if (!length) {
        ++result.segments_in_gaps;
        continue;
      }
      const Eigen::Isometry3d truth =
          matches.truth[from].T_world_camera.inverse() * matches.truth[to].T_world_camera;
      const Eigen::Isometry3d estimate =
          matches.estimate[from].T_world_camera.inverse() * matches.estimate[to].T_world_camera;
      const Eigen::Isometry3d error = estimate.inverse() * truth;
      translation += error.translation().norm() / *length;
      rotation += logSo3(error.linear()).norm() / *length;
      ++result.segments;
    }
  }
  if (result.segments == 0) return result;
  const auto count = static_cast<double>(result.segments);
  result.t_rel_percent = 100 * translation / count;
  result.r_rel_deg_per_100m = 100 * rotation / count * 180 / std::numbers::pi;
  return result;
}

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
