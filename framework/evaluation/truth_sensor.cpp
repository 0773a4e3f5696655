// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/truth_sensor.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number_text.hpp"
#include "base/text_file.hpp"
#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

using Motions = std::vector<Stretch>;
constexpr std::int64_t kNanoseconds = 1'000'000'000;  // of a second, or of a frame

/// The orthogonal matrix R of this determinant, 1 or -1, with the largest trace of products R'
/// (Arun et al. 1987).
Eigen::Matrix3d bestOrthogonal(const Eigen::Matrix3d& products, double determinant) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() * determinant < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

/// (R - I) arm = truth - estimate for each motion; R and both translations in camera axes.
Extrinsic armOf(const Motions& motions) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Stretch& each : motions) {
    const Eigen::Matrix3d J = each.truth.linear() - Eigen::Matrix3d::Identity();
    information += J.transpose() * J;
    sum += J.transpose() * (each.truth.translation() - each.estimate.translation());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(information);
  Extrinsic extrinsic;
  Eigen::Vector3d variances = Eigen::Vector3d::Zero();  // per squared residual
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d direction = parts.eigenvectors().col(i);
    const double strength = parts.eigenvalues()[i];
    const bool is_known = strength > 1e-9 * parts.eigenvalues()[2] && strength > 1e-12;
    if (is_known) extrinsic.arm += direction * direction.dot(sum) / strength;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = direction[axis] * direction[axis];
      if (is_known) variances[axis] += share / strength;
      if (!is_known && share > 0.01) variances[axis] = HUGE_VAL;
    }
  }
  double left = 1e-18;
  for (const Stretch& each : shifted(motions, extrinsic.arm)) {
    left += (each.truth.translation() - each.estimate.translation()).squaredNorm();
  }
  const double freedom = 3 * static_cast<double>(motions.size()) - 3;
  extrinsic.sigma = (variances * left / std::max(1.0, freedom)).cwiseSqrt();
  return extrinsic;
}

/// Axes and arm together, in turn.
Extrinsic axesAndArm(const Motions& motions) {
  Extrinsic extrinsic;
  Motions moved = motions;
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d R = bestAxes(moved, 1);
    extrinsic = armOf(turned(motions, R));
    extrinsic.R = R;
    moved = shifted(motions, R.transpose() * extrinsic.arm);
  }
  return extrinsic;
}

/// Mean squared difference of the angles of turns, rad^2, with the truth `offset` later.
double turnsApart(const TruthOverTime& truth, const Motions& motions, double offset) {
  double sum = 0;
  std::size_t count = 0;
  for (const Stretch& each : motions) {
    const auto from = truth.at(each.first, offset);
    const auto to = truth.at(each.last, offset);
    if (!from || !to) continue;
    const double turn =
        logSo3((from->T_world_camera.inverse() * to->T_world_camera).linear()).norm();
    const double apart = turn - logSo3(each.estimate.linear()).norm();
    sum += apart * apart;
    ++count;
  }
  return 2 * count > motions.size() ? sum / static_cast<double>(count) : HUGE_VAL;
}

}  // namespace

Eigen::Matrix3d bestAxes(const Motions& motions, double determinant) {
  Eigen::Matrix3d ways = Eigen::Matrix3d::Zero(), turns = ways;
  double lengths = 1e-30, angles = 1e-30;
  for (const Stretch& each : motions) {
    const Eigen::Vector3d true_turn = logSo3(each.truth.linear());
    const Eigen::Vector3d turn = logSo3(each.estimate.linear());
    ways += each.estimate.translation() * each.truth.translation().transpose();
    turns += turn * true_turn.transpose();
    lengths += each.estimate.translation().norm() * each.truth.translation().norm();
    angles += turn.norm() * true_turn.norm();
  }
  // A mirror turns the axes of rotations the other way.
  return bestOrthogonal(ways / lengths + determinant * turns / angles, determinant);
}

Motions turned(Motions motions, const Eigen::Matrix3d& axes) {
  for (Stretch& each : motions) {
    each.truth.linear() = axes * each.truth.linear() * axes.transpose();
    each.truth.translation() = axes * each.truth.translation();
  }
  return motions;
}

Motions shifted(Motions motions, const Eigen::Vector3d& arm) {
  for (Stretch& each : motions) each.truth.translation() += arm - each.truth.linear() * arm;
  return motions;
}

std::vector<std::size_t> stepCounts(const Matches& matches) {
  std::vector<std::size_t> counts;
  for (const std::size_t parts : {400U, 100U, 25U}) {
    counts.push_back(std::max<std::size_t>(1, matches.size() / parts));
  }
  counts.erase(std::ranges::unique(counts).begin(), counts.end());
  return counts;
}

Extrinsic extrinsicOf(const Matches& matches, bool with_axes) {
  const auto weight = [](const Extrinsic& found) {  // of the directions that are known
    return found.sigma.unaryExpr([](double s) { return std::isfinite(s) ? s : 0; }).norm();
  };
  std::optional<Extrinsic> best;
  for (const std::size_t steps : stepCounts(matches)) {
    const Motions motions = stretches(matches, steps);
    const Extrinsic found = with_axes ? axesAndArm(motions) : armOf(motions);
    if (!best || weight(found) < weight(*best)) best = found;
  }
  return *best;
}

Result<Extrinsic> parseBody(const std::string& text) {
  const auto refuse = [] {
    return Status::invalidParameter(
        "give x,y,z in m or x,y,z,qx,qy,qz,qw with a quaternion of length 1, or estimate");
  };
  std::vector<double> values;
  for (const std::string_view word : text_encoding::splitFields(text)) {
    const auto value = text_encoding::parseNumber(word);
    if (!value) return refuse();
    values.push_back(*value);
  }
  if (values.size() != 3 && values.size() != 7) return refuse();
  Extrinsic body;
  body.arm = {values[0], values[1], values[2]};
  if (values.size() == 3) return body;
  const Eigen::Quaterniond q(values[6], values[3], values[4], values[5]);
  if (std::fabs(q.norm() - 1) > 0.01) return refuse();
  body.R = q.normalized().toRotationMatrix();
  return body;
}

std::string armText(const Extrinsic& extrinsic) {
  std::vector<std::string> parts;
  for (int i = 0; i < 3; ++i) {
    const bool is_known = std::isfinite(extrinsic.sigma[i]);
    const bool is_given = extrinsic.sigma.isZero();
    parts.push_back(!is_known ? "unknown"
                    : is_given
                        ? fmt::format("{:.3g}", extrinsic.arm[i])
                        : fmt::format("{:.2f} +- {:.2f}", extrinsic.arm[i], extrinsic.sigma[i]));
  }
  return fmt::format("({}) m in the camera (x right, y down, z forward)", fmt::join(parts, ", "));
}

nlohmann::ordered_json toJson(const Extrinsic& body) {
  nlohmann::ordered_json arm, sigma;
  for (int i = 0; i < 3; ++i) {
    const bool is_known = std::isfinite(body.sigma[i]);
    arm.push_back(is_known ? nlohmann::ordered_json(body.arm[i]) : nullptr);
    sigma.push_back(is_known ? nlohmann::ordered_json(body.sigma[i]) : nullptr);
  }
  const Eigen::Quaterniond q(body.R);
  return {{"arm_m", arm}, {"sigma_m", sigma}, {"quaternion_xyzw", {q.x(), q.y(), q.z(), q.w()}}};
}

std::optional<Extrinsic> bodyOf(const Matches& matches) {
  constexpr double kTurned = 10 * std::numbers::pi / 180;
  constexpr std::size_t kFewest = 20;  // poses
  if (matches.size() < kFewest || !hasOrientations(matches.truth)) return std::nullopt;
  const Extrinsic body = extrinsicOf(matches, true);
  return logSo3(body.R).norm() > kTurned ? body : extrinsicOf(matches, false);
}

TruthOverTime::TruthOverTime(Trajectory truth, const Matches& matches, bool by_stamp)
    : in_frames_(!hasStamps(truth)), truth_(std::move(truth)) {
  const auto stampOf = [&](const TrajectoryPose& pose) {
    return in_frames_ ? pose.frame * kNanoseconds : pose.stamp_ns;
  };
  for (TrajectoryPose& pose : truth_) pose.stamp_ns = stampOf(pose);
  for (const auto& pose : by_stamp && !in_frames_ ? matches.estimate : matches.truth) {
    pairs_.push_back(stampOf(pose));
  }
}

double TruthOverTime::periodOfPairs() const {
  return static_cast<double>(pairs_.back() - pairs_.front()) / kNanoseconds /
         static_cast<double>(pairs_.size());
}

double TruthOverTime::duration() const {
  return static_cast<double>(truth_.back().stamp_ns - truth_.front().stamp_ns) / kNanoseconds;
}

std::optional<PoseAt> TruthOverTime::at(std::size_t i, double offset) const {
  return poseAt(truth_, pairs_[i] + std::llround(offset * kNanoseconds));
}

std::optional<ClockOffset> clockOffset(const TruthOverTime& truth, const Matches& matches) {
  constexpr double kSeconds = 2, kFrames = 20;  // largest offset
  constexpr std::size_t kMost = 1000;           // motions
  constexpr std::size_t kFewest = 10;
  const Motions all = stretches(matches, 1);
  if (all.size() < kFewest) return std::nullopt;
  Motions motions;
  for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / kMost) motions.push_back(all[i]);
  const double most = std::min(truth.inFrames() ? kFrames : kSeconds, truth.duration() / 10);
  const double step = std::max(truth.periodOfPairs() / 2, most / 200);
  double best = 0, least = turnsApart(truth, motions, 0);
  for (double offset = -most; offset <= most; offset += step) {
    const double apart = turnsApart(truth, motions, offset);
    if (apart < least) least = apart, best = offset;
  }
  double low = best - step, high = best + step;
  for (int i = 0; i < 25; ++i) {
    const double third = (high - low) / 3;
    const bool is_low =
        turnsApart(truth, motions, low + third) < turnsApart(truth, motions, high - third);
    (is_low ? high : low) += is_low ? -third : third;
  }
  best = (low + high) / 2;
  // The curvature of the sum of squares at its minimum gives the variance.
  const double left = turnsApart(truth, motions, best);
  const double curvature = (turnsApart(truth, motions, best - step) +
                            turnsApart(truth, motions, best + step) - 2 * left) /
                           (step * step);
  const auto count = static_cast<double>(motions.size());
  return ClockOffset{best, std::sqrt(2 * left / (count * std::max(curvature, 1e-300)))};
}

Matches delayed(const TruthOverTime& truth, Matches matches, double offset) {
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto pose = truth.at(i, offset);
    if (pose) matches.truth[i].T_world_camera = pose->T_world_camera;
    if (!pose) matches.estimate[i].tracked = false;
  }
  return matches;
}

}  // namespace tolman::evaluation
