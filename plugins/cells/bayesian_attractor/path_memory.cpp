// SPDX-License-Identifier: BSD-3-Clause
// Covariance of dead reckoning. A turn that went wrong by e at place q moves a later place p by
// e * perp(p - q), perp(x, y) = (-y, x); summed over all q this needs only the moments of q.
#include "path_memory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::bayesian_attractor {
namespace {

/// So many short cuts are remembered: near ones in time are the surest.
constexpr std::size_t kLoopsRemembered = 100;

Eigen::Matrix3d turned(const Eigen::Matrix3d& covariance, double angle) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
  return R * covariance * R.transpose();
}

/// The error of a pose, carried on to a place (x, y) beyond it.
Eigen::Matrix3d carried(const Eigen::Matrix3d& covariance, double x, double y) {
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J(0, 2) = -y;
  J(1, 2) = x;
  return J * covariance * J.transpose();
}

/// Covariance of `to` given `from`, the earlier one, along the axes of dead reckoning.
Eigen::Matrix3d driftOf(const PathMark& from, const PathMark& to, const DriftSettings& settings) {
  const double x = to.pose.x;
  const double y = to.pose.y;
  const Eigen::Matrix<double, 6, 1> m = to.turns - from.turns;
  const double sum_x = m(0) * x - m(1);
  const double sum_y = m(0) * y - m(2);
  const double sum_xx = m(0) * x * x - 2 * x * m(1) + m(3);
  const double sum_xy = m(0) * x * y - x * m(2) - y * m(1) + m(4);
  const double sum_yy = m(0) * y * y - 2 * y * m(2) + m(5);
  Eigen::Matrix3d covariance;
  covariance << sum_yy, -sum_xy, -sum_y, -sum_xy, sum_xx, sum_x, -sum_y, sum_x, m(0);

  const Eigen::Vector3d n = to.lengths - from.lengths;
  const Eigen::Vector3d pull(-(n(0) * y - n(2)), n(0) * x - n(1), n(0));
  covariance += settings.heading * settings.heading * pull * pull.transpose();
  const Eigen::Vector3d stretch(x - from.pose.x, y - from.pose.y, 0);
  covariance += settings.scale * settings.scale * stretch * stretch.transpose();
  covariance.diagonal().head<2>().array() += to.step_variance - from.step_variance;
  return covariance;
}

}  // namespace

UncertainStep chained(const UncertainStep& a, const UncertainStep& b) {
  const PlanarPose end = compose(a.pose, b.pose);
  return {end, carried(a.covariance, end.x - a.pose.x, end.y - a.pose.y) +
                   turned(b.covariance, a.pose.theta)};
}

UncertainStep inverse(const UncertainStep& a) {
  // Seen along the axes of a's start, the start moves against the error of the end.
  const Eigen::Matrix3d at_start = carried(a.covariance, -a.pose.x, -a.pose.y);
  return {tolman::between(a.pose, {}), turned(at_start, -a.pose.theta)};
}

double chiSquare(const UncertainStep& a, const UncertainStep& b) {
  const Eigen::Vector3d error(a.pose.x - b.pose.x, a.pose.y - b.pose.y,
                              wrapAngle(a.pose.theta - b.pose.theta));
  const Eigen::Matrix3d covariance = a.covariance + b.covariance;
  return error.dot(covariance.ldlt().solve(error));
}

void PathMemory::advance(const PlanarPose& motion, double step_variance, double turn_variance) {
  ++now_.step;
  now_.pose = compose(now_.pose, motion);
  const double x = now_.pose.x;
  const double y = now_.pose.y;
  Eigen::Matrix<double, 6, 1> moments;
  moments << 1, x, y, x * x, x * y, y * y;
  now_.turns += turn_variance * moments;
  now_.lengths += std::hypot(motion.x, motion.y) * Eigen::Vector3d(1, x, y);
  now_.step_variance += step_variance;
  least_ = least_.cwiseMin(Eigen::Vector2d(x, y));
  most_ = most_.cwiseMax(Eigen::Vector2d(x, y));
}

UncertainStep PathMemory::between(const PathMark& from, const PathMark& to) const {
  if (to.step < from.step) return inverse(between(to, from));
  return {tolman::between(from.pose, to.pose),
          turned(driftOf(from, to, settings_), -from.pose.theta)};
}

UncertainStep PathMemory::over(const ClosedLoop& loop, const PathMark& from) const {
  return chained(chained(between(from, loop.home), loop.offset), between(loop.visit, now_));
}

bool PathMemory::leads(const ClosedLoop& loop, const PathMark& from) const {
  return loop.home.part == from.part && loop.visit.part == now_.part;
}

bool PathMemory::reaches(const PathMark& from) const {
  return from.part == now_.part ||
         std::ranges::any_of(loops_, [&](const ClosedLoop& loop) { return leads(loop, from); });
}

UncertainStep PathMemory::predict(const PathMark& from) const {
  UncertainStep surest;
  double least = std::numeric_limits<double>::infinity();
  if (from.part == now_.part) {
    surest = between(from, now_);
    least = surest.covariance.determinant();
  }
  for (const ClosedLoop& loop : loops_) {
    if (!leads(loop, from)) continue;
    const UncertainStep other = over(loop, from);
    const double determinant = other.covariance.determinant();
    if (determinant >= least) continue;
    surest = other;
    least = determinant;
  }
  return surest;
}

void PathMemory::close(const PathMark& home, const UncertainStep& offset, double gate) {
  std::erase_if(loops_, [&](const ClosedLoop& loop) {
    return leads(loop, home) && chiSquare(over(loop, home), offset) > gate;
  });
  loops_.push_back({home, now_, offset});
  if (loops_.size() > kLoopsRemembered) forgetOne();
}

/// The oldest, but what leads over a gap only when there is nothing else.
void PathMemory::forgetOne() {
  const auto within = std::ranges::find_if(
      loops_, [](const ClosedLoop& loop) { return loop.home.part == loop.visit.part; });
  loops_.erase(within == loops_.end() ? loops_.begin() : within);
}

double PathMemory::exploredArea(double margin) const {
  return (most_ - least_ + Eigen::Vector2d::Constant(2 * margin)).prod();
}

void PathMemory::restore(const State& state) {
  now_ = state.now;
  least_ = state.least;
  most_ = state.most;
  loops_ = state.loops;
}

}  // namespace tolman::bayesian_attractor
