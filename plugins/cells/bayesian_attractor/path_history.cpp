// SPDX-License-Identifier: BSD-3-Clause
#include "path_history.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <numbers>

#include "conjunctive_code.hpp"

namespace tolman::bayesian_attractor {

void Traced::move(const PlanarPose& step, const PathErrors& step_errors) {
  const Eigen::Vector2d displacement =
      Eigen::Rotation2Dd(pose.theta) * Eigen::Vector2d(step.x, step.y);
  errors = displaced(errors, displacement) + turned(step_errors, pose.theta);
  pose = compose(pose, step);
}

void Traced::move(const PlanarPose& step, const Eigen::Matrix3d& noise,
                  const PathErrors& step_errors) {
  const double heading = pose.theta;
  const PlanarPose before = pose;
  move(step, step_errors);
  const Eigen::Matrix3d J = displacementJacobian({pose.x - before.x, pose.y - before.y});
  covariance = J * covariance * J.transpose() + turned(noise, heading);
}

namespace {

/// Appends a step to a motion.
void append(PathPiece& piece, const PlanarPose& step, const Eigen::Matrix3d& noise,
            const ErrorEffect& effect) {
  Traced end = {piece.motion, piece.noise, {piece.effect, Eigen::Vector3d::Zero()}};
  end.move(step, noise, {effect, Eigen::Vector3d::Zero()});
  piece.motion = end.pose;
  piece.noise = end.covariance;
  piece.effect = end.errors.effect;
}

}  // namespace

void PathHistory::advance(const PlanarPose& reported, const PlanarPose& corrected,
                          const Eigen::Matrix3d& noise, const ErrorEffect& effect, double spacing) {
  const PathPiece& last = pieces_.back();
  if (last.length >= spacing || last.origin >= 0 || last.unknown) {
    pieces_.push_back({.begin = here_});
  }
  append(pieces_.back(), reported, noise, effect);
  pieces_.back().length += std::hypot(reported.x, reported.y);
  here_ = compose(here_, corrected);
}

void PathHistory::startPart() { pieces_.push_back({.unknown = true, .begin = here_}); }

void PathHistory::jump(std::int64_t origin, const PlanarPose& offset,
                       const Eigen::Matrix3d& covariance) {
  pieces_.push_back(
      {.origin = origin, .motion = offset, .noise = covariance, .begin = beginOf(origin)});
  here_ = compose(beginOf(origin), offset);
}

std::int64_t PathHistory::rootOf(std::int64_t k) const {
  const auto at = [&](std::int64_t i) -> const PathPiece& {
    return pieces_[static_cast<std::size_t>(i)];
  };
  while (k > 0 && !at(k).unknown) k = at(k).origin >= 0 ? at(k).origin : k - 1;
  return k;
}

/// The part is moved as it is. Traced again, it begins where the way back from here leads, which
/// depends on the steady errors to first order.
void PathHistory::join(std::int64_t origin, const PlanarPose& offset,
                       const Eigen::Matrix3d& covariance) {
  const std::int64_t root = rootOf(last());
  PathPiece& first = pieces_[static_cast<std::size_t>(root)];
  const PlanarPose from = first.begin;
  const Traced reported = trace(ErrorVector::Zero(), root, false).back();
  const PathErrors errors = turned(reported.errors, -from.theta);
  const PlanarPose way = between(from, reported.pose);
  const PlanarPose to = compose(compose(beginOf(origin), offset), between(here_, from));
  for (std::int64_t k = last(); k >= root; --k) {
    PlanarPose& begin = pieces_[static_cast<std::size_t>(k)].begin;
    if (rootOf(k) == root) begin = compose(to, between(from, begin));
  }
  if (origin > root) return;
  const PathErrors back = PathErrors{} - displaced(errors, {-way.x, -way.y});
  first.origin = origin;
  first.unknown = false;
  first.motion = compose(offset, between(way, {}));
  first.effect = turned(back, offset.theta - way.theta).effect;
  first.noise = covariance;
}

std::int64_t PathHistory::firstOfWay(std::int64_t from) const {
  for (std::int64_t k = last(); k >= from; --k) {
    const std::int64_t origin = pieces_[static_cast<std::size_t>(k)].origin;
    if (origin >= 0) from = std::min(from, origin);
  }
  return from;
}

std::vector<Traced> PathHistory::trace(const ErrorVector& errors, std::int64_t first,
                                       bool covariances) const {
  const auto begin = static_cast<std::size_t>(first);
  std::vector<Traced> traced;
  traced.reserve(pieces_.size() + 1 - begin);
  Traced end = {pieces_[begin].begin};
  for (std::size_t k = begin; k < pieces_.size(); ++k) {
    const PathPiece& piece = pieces_[k];
    if (piece.unknown) end = {piece.begin, Eigen::Matrix3d::Zero(), end.errors};
    if (piece.origin >= 0 && k > begin)
      end = traced[static_cast<std::size_t>(piece.origin) - begin];
    traced.push_back(end);
    const Eigen::Vector3d by = piece.effect * errors;
    const PlanarPose step = {piece.motion.x + by.x(), piece.motion.y + by.y(),
                             piece.motion.theta + by.z()};
    if (covariances) {
      end.move(step, piece.noise, {piece.effect, by});
    } else {
      end.move(step, {piece.effect, by});
    }
  }
  traced.push_back(end);
  return traced;
}

void PathHistory::accept(const std::vector<Traced>& trace) {
  for (std::size_t k = 0; k < pieces_.size(); ++k) pieces_[k].begin = trace[k].pose;
  here_ = trace.back().pose;
}

void PathHistory::restore(std::vector<PathPiece> pieces, const PlanarPose& here) {
  pieces_ = std::move(pieces);
  here_ = here;
}

double logStudent(double squared, const Eigen::Matrix3d& covariance, double tail) {
  return std::lgamma((tail + 3) / 2) - std::lgamma(tail / 2) -
         1.5 * std::log(tail * std::numbers::pi) - 0.5 * std::log(covariance.determinant()) -
         (tail + 3) / 2 * std::log1p(squared / tail);
}

namespace {

/// The view's pose minus that of path integration, and the effect of errors between them.
struct Closure {
  Eigen::Vector3d off;
  ErrorEffect effect;
  Eigen::Matrix3d noise;
};

Closure closureOf(const PathHistory& path, const ErrorVector& errors, const TracedView& view,
                  std::int64_t first, bool covariances) {
  const std::vector<Traced> traced = path.trace(errors, first, covariances);
  const Traced& here = traced.back();
  Traced there = traced[static_cast<std::size_t>(view.piece - first)];
  there.move(view.pose, Eigen::Matrix3d::Zero(), {});
  Closure closure;
  closure.off << there.pose.x - here.pose.x, there.pose.y - here.pose.y,
      wrapAngle(there.pose.theta - here.pose.theta);
  const Eigen::Vector2d back = -closure.off.head<2>();
  closure.effect = (here.errors - displaced(there.errors, back)).effect;
  const Eigen::Matrix3d J = displacementJacobian(back);
  closure.noise = absolute(here.covariance - J * there.covariance * J.transpose());
  return closure;
}

}  // namespace

TracedLoop traceLoop(const PathHistory& path, const ErrorEstimate& prior, const TracedView& view,
                     double tail) {
  constexpr double kRange = 3;  // standard deviations of the turn; chosen, not tuned
  constexpr int kSteps = 3;     // chosen, not tuned
  const std::int64_t first = path.firstOfWay(view.piece);
  const Closure start = closureOf(path, prior.mean, view, first, false);
  const double heading = view.covariance(2, 2);
  const double range =
      kRange *
      std::sqrt(start.effect.row(2).dot(prior.covariance * start.effect.row(2).transpose()));
  TracedLoop loop = {prior, 0};
  double most = 0;
  for (double turn = start.off.z() - kTurn * std::floor((start.off.z() + range) / kTurn);
       turn <= range; turn += kTurn) {
    // Only the heading is linear in the errors.
    ErrorEstimate found = prior;
    update(found, start.effect, {0, 0, turn}, Eigen::Vector3d(1e9, 1e9, heading).asDiagonal());
    Eigen::Matrix3d noise;
    double density = 0;
    for (int step = 0; step < kSteps; ++step) {
      const Closure end = closureOf(path, found.mean, view, first, step == 0);
      if (step == 0) noise = end.noise + view.covariance;
      const ErrorVector away = found.mean - prior.mean;
      const Eigen::Matrix3d S = noise + end.effect * prior.covariance * end.effect.transpose();
      const Eigen::Vector3d innovation = end.off + end.effect * away;
      const double squared = innovation.dot(S.ldlt().solve(innovation));
      density = std::exp(logStudent(squared, S, tail));
      found = prior;
      update(found, end.effect, innovation, noise / std::min(1.0, (tail + 3) / (tail + squared)));
    }
    loop.density += density;
    if (density < most) continue;
    most = density;
    loop.estimate = found;
  }
  loop.estimate.log_weight = prior.log_weight;
  return loop;
}

}  // namespace tolman::bayesian_attractor
