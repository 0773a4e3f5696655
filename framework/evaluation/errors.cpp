// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/errors.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
using StepPairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// `as_written`: of matrices that are no exact rotations.
Eigen::Isometry3d inverseOf(const Eigen::Isometry3d& T, bool as_written) {
  return T.inverse(as_written ? Eigen::Affine : Eigen::Isometry);
}
Eigen::Isometry3d motionOf(const Trajectory& path, std::size_t from, std::size_t to,
                           bool as_written = false) {
  return inverseOf(path[from].T_world_camera, as_written) * path[to].T_world_camera;
}
double angleOf(const Eigen::Isometry3d& motion) { return logSo3(motion.linear()).norm() / kDegree; }
/// By the trace, as programs that take matrices as they are written.
double traceAngle(const Eigen::Isometry3d& motion) {
  return std::acos(std::clamp((motion.linear().trace() - 1) / 2, -1.0, 1.0)) / kDegree;
}

/// What steps are measured in, summed up to each pair; for Closest also to the pose after them.
std::vector<double> sumsOf(const Matches& matches, const Steps& steps) {
  std::vector<double> sums;
  Trajectory estimate = matches.estimate;
  const bool goes_on = steps.end == StepEnd::Closest && !steps.of_truth && matches.after;
  if (goes_on) estimate.push_back(*matches.after);
  const Trajectory& path = steps.of_truth ? matches.truth : estimate;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double before = i > 0 ? sums.back() : 0;
    switch (steps.unit) {
      case StepUnit::Frames:
        sums.push_back(static_cast<double>(estimate[i].frame));
        break;
      case StepUnit::Poses:
        sums.push_back(static_cast<double>(i));
        break;
      case StepUnit::Seconds:
        sums.push_back(1e-9 * static_cast<double>(estimate[i].stamp_ns - estimate[0].stamp_ns));
        break;
      case StepUnit::Metres:
        sums.push_back(i == 0 ? 0 : before + motionOf(path, i - 1, i).translation().norm());
        break;
      case StepUnit::Degrees:
        sums.push_back(i == 0 ? 0 : before + angleOf(motionOf(path, i - 1, i)));
        break;
    }
  }
  if (steps.unit == StepUnit::Metres && steps.of_truth && !steps.over_gaps) return matches.driven;
  return sums;
}

/// The pair where a step from `from` ends; none where the path is too short.
std::optional<std::size_t> endOf(const std::vector<double>& sums, std::size_t from,
                                 const Steps& steps) {
  constexpr double kRounding = 1e-9;  // of the length
  const double wanted = sums[from] + steps.length;
  const bool is_closest = steps.end == StepEnd::Closest;
  const auto begin = sums.begin() + static_cast<std::ptrdiff_t>(from) + (is_closest ? 0 : 1);
  auto end = std::lower_bound(begin, sums.end(), wanted - kRounding * steps.length);
  const bool counts = steps.unit == StepUnit::Frames || steps.unit == StepUnit::Poses;
  if (!is_closest && counts && (end == sums.end() || *end != wanted)) return std::nullopt;
  if (steps.end == StepEnd::First) {
    if (end == sums.end()) return std::nullopt;
    return static_cast<std::size_t>(end - sums.begin());
  }
  if (begin == sums.end()) return std::nullopt;
  if (end == sums.end() || (end != begin && wanted - *(end - 1) <= *end - wanted)) --end;
  if (steps.end == StepEnd::Closest) {
    if (end + 1 == sums.end()) return std::nullopt;
  } else if (std::fabs(*end - wanted) > 0.1 * steps.length * (1 + kRounding)) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(end - sums.begin());
}

/// Both ends of all steps whose direct angle is the length but for a tenth.
StepPairs turnsOf(const Trajectory& path, double degrees) {
  StepPairs pairs;
  for (std::size_t from = 0; from < path.size(); ++from) {
    for (std::size_t to = from + 1; to < path.size(); ++to) {
      const double angle = angleOf(motionOf(path, from, to));
      if (std::fabs(angle - degrees) <= 0.1 * degrees) pairs.emplace_back(from, to);
    }
  }
  return pairs;
}

StepPairs stepPairs(const Matches& matches, const Steps& steps) {
  if (steps.all && steps.unit == StepUnit::Degrees && steps.end == StepEnd::Tenth) {
    return turnsOf(steps.of_truth ? matches.truth : matches.estimate, steps.length);
  }
  StepPairs pairs;
  const std::vector<double> sums = sumsOf(matches, steps);
  Steps consecutive = steps;
  consecutive.end = StepEnd::First;
  for (std::size_t from = 0; from < matches.size();) {
    const auto to = endOf(sums, from, steps.all ? steps : consecutive);
    if (to && (steps.over_gaps || matches.inOnePiece(from, *to))) pairs.emplace_back(from, *to);
    if (!steps.all && !to) break;
    from = steps.all ? from + 1 : *to;
  }
  // The path of consecutive steps in metres begins at the first end, as evo's does.
  const bool skips = !steps.all && steps.unit == StepUnit::Metres && steps.end == StepEnd::Tenth;
  if (skips && !pairs.empty()) pairs.erase(pairs.begin());
  return pairs;
}

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

/// Sums of the errors of segments; `single`: in single precision, as KITTI's program has them,
/// which scales them after it has summed them up.
class SegmentSums {
 public:
  SegmentSums(double length_m, bool single) : single_(single), sums_{length_m, 0, 0, 0} {}

  void add(const Eigen::Isometry3d& error, double length, bool by_trace) {
    ++sums_.segments;
    if (!single_) {
      sums_.t_rel_percent += 100 * error.translation().norm() / length;
      sums_.r_rel_deg_per_100m += 100 * (by_trace ? traceAngle(error) : angleOf(error)) / length;
      return;
    }
    const Eigen::Vector3f d = error.linear().diagonal().cast<float>();
    const auto cosine = static_cast<float>(0.5 * ((d[0] + d[1]) + d[2] - 1.0));
    const float angle = std::acos(std::clamp(cosine, -1.0F, 1.0F));
    const auto nominal = static_cast<float>(length);
    t_ += singleNorm(error.translation()) / nominal;
    r_ += angle / nominal;
  }
  void add(const SegmentSums& other) {
    sums_.segments += other.sums_.segments;
    sums_.t_rel_percent += other.sums_.t_rel_percent;
    sums_.r_rel_deg_per_100m += other.sums_.r_rel_deg_per_100m;
  }
  SegmentMean means() const {
    const double count = std::max(1.0, static_cast<double>(sums_.segments));
    if (single_) {
      const auto divisor = static_cast<float>(count);
      return {sums_.length_m, sums_.segments, 100 * static_cast<double>(t_ / divisor),
              100 * static_cast<double>(r_ / divisor) / kDegree};
    }
    return {sums_.length_m, sums_.segments, sums_.t_rel_percent / count,
            sums_.r_rel_deg_per_100m / count};
  }
  static float singleNorm(const Eigen::Vector3d& vector) {
    const Eigen::Vector3f v = vector.cast<float>();
    return std::sqrt((v.x() * v.x() + v.y() * v.y()) + v.z() * v.z());
  }

 private:
  bool single_;
  SegmentMean sums_;
  float t_ = 0;
  float r_ = 0;
};

std::vector<double> singleDistances(const Trajectory& path) {
  std::vector<double> result;
  float distance = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      distance += SegmentSums::singleNorm(path[i].T_world_camera.translation() -
                                          path[i - 1].T_world_camera.translation());
    }
    result.push_back(static_cast<double>(distance));
  }
  return result;
}

/// From each position to the nearest point of the path.
std::vector<double> distancesToPath(const Trajectory& positions, const Trajectory& path) {
  const Eigen::Matrix3Xd points = evaluation::positions(path);
  const Eigen::Index edges = std::max<Eigen::Index>(1, points.cols() - 1);
  const Eigen::Matrix3Xd ways = points.rightCols(edges) - points.leftCols(edges);
  const Eigen::ArrayXd squares = ways.colwise().squaredNorm().transpose().array().max(1e-300);
  std::vector<double> result;
  for (const TrajectoryPose& pose : positions) {
    const Eigen::Matrix3Xd to =
        (-points.leftCols(edges)).colwise() + pose.T_world_camera.translation();
    const Eigen::ArrayXd share =
        (to.cwiseProduct(ways).colwise().sum().transpose().array() / squares).max(0.0).min(1.0);
    const Eigen::Matrix3Xd apart = to - ways * share.matrix().asDiagonal();
    result.push_back(std::sqrt(apart.colwise().squaredNorm().minCoeff()));
  }
  return result;
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
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  if (values.size() > 1) result.deviation = std::sqrt(squares / (count - 1));
  result.median = quantile(values, 0.5);
  result.p90 = quantile(values, 0.9);
  result.min = values.front();
  result.max = values.back();
  return result;
}

double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
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

std::vector<double> rotationErrors(const Matches& aligned) {
  std::vector<double> values;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    values.push_back(
        angleOf(aligned.estimate[i].T_world_camera.inverse() * aligned.truth[i].T_world_camera));
  }
  return values;
}

PathDistance pathDistance(const Trajectory& truth, const Trajectory& aligned) {
  PathDistance result;
  std::vector<double> there = distancesToPath(aligned, truth);
  const std::vector<double> back = distancesToPath(truth, aligned);
  result.hausdorff_m = std::max(std::ranges::max(there), std::ranges::max(back));
  result.to_truth_m = statistics(std::move(there));
  return result;
}

RelativeError relativeError(const Matches& aligned, const Steps& steps) {
  std::vector<double> translations, rotations, lengths, percents;
  for (const auto& [from, to] : stepPairs(aligned, steps)) {
    const Eigen::Isometry3d truth = motionOf(aligned.truth, from, to, steps.as_written);
    const Eigen::Isometry3d estimate = motionOf(aligned.estimate, from, to, steps.as_written);
    const Eigen::Isometry3d error = steps.in_end_frame
                                        ? truth * estimate.inverse()
                                        : inverseOf(truth, steps.as_written) * estimate;
    const double divisor = steps.divided ? aligned.driven[to] - aligned.driven[from] : 1;
    translations.push_back(error.translation().norm() / divisor);
    rotations.push_back((steps.as_written ? traceAngle(error) : angleOf(error)) / divisor);
    const double length = truth.translation().norm();
    lengths.push_back(std::fabs(estimate.translation().norm() - length));
    if (length > 0) percents.push_back(100 * lengths.back() / length);
  }
  return {statistics(std::move(translations)), statistics(std::move(rotations)),
          statistics(std::move(lengths)), statistics(std::move(percents))};
}

SegmentLengths kittiLengths() { return {"kitti", {100, 200, 300, 400, 500, 600, 700, 800}}; }

SegmentLengths shortLengths() { return {"short", {5, 10, 20, 30, 40, 50}}; }

SegmentLengths lengthsFor(double truth_path_length_m) {
  return truth_path_length_m >= 200 ? kittiLengths() : shortLengths();
}

SegmentErrors segmentErrors(const Matches& matches, const SegmentLengths& lengths,
                            const Trajectory* whole_truth, bool single) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  SegmentErrors result;
  result.lengths = lengths;
  const bool whole = whole_truth != nullptr;
  const std::vector<double> driven = !whole   ? matches.driven
                                     : single ? singleDistances(*whole_truth)
                                              : distances(*whole_truth);
  std::vector<std::size_t> pair(driven.size(), kNone);  // of each place where segments begin or end
  for (std::size_t i = 0; i < matches.size(); ++i) pair[whole ? matches.index[i] : i] = i;
  SegmentSums all(0, single);
  std::vector<SegmentSums> sums;
  for (const double length : lengths.lengths_m) sums.emplace_back(length, single);
  for (std::size_t start = 0; start < driven.size(); start += kStartEvery) {
    for (std::size_t l = 0; l < sums.size(); ++l) {
      const double nominal = lengths.lengths_m[l];
      const auto end = std::upper_bound(driven.begin(), driven.end(), driven[start] + nominal);
      if (end == driven.end()) continue;
      const std::size_t from = pair[start],
                        to = pair[static_cast<std::size_t>(end - driven.begin())];
      const auto length = from == kNone || to == kNone ? std::nullopt
                          : whole                      ? std::optional(nominal)
                                                       : lengthOf(matches, from, to, nominal);
      if (!length) {
        ++result.segments_in_gaps;
        continue;
      }
      const Eigen::Isometry3d error =
          inverseOf(motionOf(matches.estimate, from, to, whole), whole) *
          motionOf(matches.truth, from, to, whole);
      sums[l].add(error, *length, whole);
      if (single) all.add(error, *length, whole);
    }
  }
  for (const SegmentSums& each : sums) {
    if (!single) all.add(each);
    result.table.push_back(each.means());
  }
  const SegmentMean mean = all.means();
  result.segments = mean.segments;
  result.t_rel_percent = mean.t_rel_percent;
  result.r_rel_deg_per_100m = mean.r_rel_deg_per_100m;
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
