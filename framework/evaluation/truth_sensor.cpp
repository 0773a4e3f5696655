// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/truth_sensor.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

using Motions = std::vector<Stretch>;

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

double timeOf(const TrajectoryPose& pose, bool in_frames) {
  return in_frames ? static_cast<double>(pose.frame) : 1e-9 * static_cast<double>(pose.stamp_ns);
}

/// Mean squared difference of the angles of turns, rad^2, with the truth `offset` later.
double turnsApart(const TruthOverTime& truth, const Motions& motions, double offset) {
  double sum = 0;
  std::size_t count = 0;
  for (const Stretch& each : motions) {
    const auto from = truth.at(truth.timeOfPair(each.first) + offset);
    const auto to = truth.at(truth.timeOfPair(each.last) + offset);
    if (!from || !to) continue;
    const double turn = logSo3(from->linear().transpose() * to->linear()).norm();
    const double apart = turn - logSo3(each.estimate.linear()).norm();
    sum += apart * apart;
    ++count;
  }
  return 2 * count > motions.size() ? sum / static_cast<double>(count) : HUGE_VAL;
}

}  // namespace

Eigen::Matrix3d bestOrthogonal(const Eigen::Matrix3d& products, double determinant) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(products, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() * determinant < 0) u.col(2) *= -1;
  return u * svd.matrixV().transpose();
}

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

TruthOverTime::TruthOverTime(const Trajectory& truth, const Matches& matches, bool by_stamp)
    : truth_(truth), in_frames_(!hasStamps(truth)) {
  const double origin = timeOf(truth.front(), in_frames_);
  const auto since = [&](const Trajectory& path) {
    std::vector<double> times;
    for (const TrajectoryPose& pose : path) times.push_back(timeOf(pose, in_frames_) - origin);
    return times;
  };
  times_ = since(truth);
  pairs_ = since(by_stamp && !in_frames_ ? matches.estimate : matches.truth);
}

std::optional<Eigen::Isometry3d> TruthOverTime::at(double time) const {
  const auto after = std::ranges::upper_bound(times_, time);
  if (after == times_.begin() || time > times_.back()) return std::nullopt;
  const auto i = std::min(static_cast<std::size_t>(after - times_.begin()), times_.size() - 1);
  const double part = (time - times_[i - 1]) / (times_[i] - times_[i - 1]);
  const Eigen::Isometry3d& a = truth_[i - 1].T_world_camera;
  const Eigen::Isometry3d& b = truth_[i].T_world_camera;
  Eigen::Isometry3d between = Eigen::Isometry3d::Identity();
  between.linear() =
      Eigen::Quaterniond(a.linear()).slerp(part, Eigen::Quaterniond(b.linear())).toRotationMatrix();
  between.translation() = (1 - part) * a.translation() + part * b.translation();
  return between;
}

std::optional<double> clockOffset(const TruthOverTime& truth, const Matches& matches) {
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
  return (low + high) / 2;
}

Matches delayed(const TruthOverTime& truth, Matches matches, double offset) {
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const auto pose = truth.at(truth.timeOfPair(i) + offset);
    if (pose) matches.truth[i].T_world_camera = *pose;
    if (!pose) matches.estimate[i].tracked = false;
  }
  return matches;
}

}  // namespace tolman::evaluation
