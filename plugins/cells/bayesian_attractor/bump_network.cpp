// SPDX-License-Identifier: BSD-3-Clause
#include "bump_network.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::bayesian_attractor {
namespace {

/// 99 % quantile of chi-square with three degrees of freedom: a view below it agrees with a bump.
constexpr double kAgrees = 11.345;
/// Largest squared height difference that agrees, in variances: three standard deviations.
constexpr double kSameStorey = 9;
/// m around the path that count as explored, and the smallest explored area, m^2. Both chosen, not
/// tuned.
constexpr double kMargin = 20;
constexpr double kMinArea = 1e4;
/// Calibration bumps below this energy, in nats, are removed: a share of less than 0.04 %.
/// Chosen, not tuned; bounds the time.
constexpr double kMinEnergy = -8;
/// Bounds of the learned share of right views. Chosen, not tuned; keep its log odds finite.
constexpr double kMinPrior = 0.001;
constexpr double kMaxPrior = 0.9;
/// Turn, in rad, up to which the shape of a path is linear in its steady errors. Chosen, not tuned.
constexpr double kLinearTurn = 0.3;
/// Most nats that a closed loop counts whose way must be bent to close. Chosen among 0 to 4 on 00,
/// 06 and 02, with odometry that turns too far and with look-alikes of the seeds 11 and 12.
constexpr double kMostBent = 1;
/// Standard deviation of a turn above which it is found by tracing, rad.
constexpr double kOpenTurn = 2 * kLinearTurn;

double logGaussian(const Eigen::Vector3d& difference, const Eigen::Matrix3d& covariance) {
  return -0.5 * (squaredMahalanobis(difference, covariance) + std::log(covariance.determinant()) +
                 3 * std::log(kTurn));
}

/// Squared difference in height over its variance; 0 for variance 0 (no vertical modules).
double squaredClimb(double climb, double variance) {
  return variance > 0 ? climb * climb / variance : 0;
}

}  // namespace

BumpNetwork::BumpNetwork(const NetworkSettings& settings)
    : settings_(settings),
      code_(GridCode(settings.period, settings.modules, settings.phase_sigma),
            HeightCode(settings.height_period, settings.height_period > 0 ? settings.modules : 0,
                       settings.phase_sigma)) {
  state_.integrator.centre = code_.origin();
  state_.stretch_start = state_.integrator;
}

void BumpNetwork::integrate(const PlanarPose& reported_step, const Eigen::Matrix3d& reported,
                            const Climb& climb, double seconds) {
  changes_.clear();
  PathErrors errors;
  PlanarPose step = reported_step;
  double factor = 1;
  if (settings_.recalibrate) {
    errors.effect = effectOf(reported_step, seconds);
    errors.applied = errors.effect * state_.path.mixed.mean;
    step.x += errors.applied.x();
    step.y += errors.applied.y();
    step.theta += errors.applied.z();
    factor = state_.path.noise * state_.path.noise;
  }
  const double length = std::hypot(step.x, step.y);
  const double along = settings_.drift_position * settings_.drift_position * length;
  const double turn = settings_.drift_heading * settings_.drift_heading * length;
  Eigen::Matrix3d noise = reported;
  noise.diagonal() += Eigen::Vector3d(along, along, turn);
  noise *= factor;
  if (settings_.recalibrate && !settings_.localise) {
    state_.history.advance(reported_step, step, noise, errors.effect, settings_.view_spacing);
  }
  const double drift = settings_.drift_height * settings_.drift_height * length;
  const Climb rise = {climb.metres, climb.variance + drift};
  code_.move(state_.integrator, step, noise, rise, errors);
  for (CalibrationBump& c : state_.calibration) {
    code_.move(c.bump, step, noise, rise, errors);
    c.energy -= settings_.inhibition * length;
  }
  state_.travel += length;
  if (!settings_.localise) {
    const Eigen::Vector2d here =
        code_.difference(code_.origin(), state_.integrator.centre).head<2>();
    state_.explored_min = state_.explored_min.cwiseMin(here);
    state_.explored_max = state_.explored_max.cwiseMax(here);
  }
  for (const CalibrationBump& c : state_.calibration) {
    if (c.energy < kMinEnergy) note(c, Fate::Faded);
  }
  std::erase_if(state_.calibration, [](const CalibrationBump& c) { return c.energy < kMinEnergy; });
}

void BumpNetwork::note(const CalibrationBump& bump, Fate fate, double change) {
  changes_.push_back({bump.id, fate, -1, bump.energy, change, share(bump.energy),
                      settings_.threshold, bump.views, state_.travel - bump.last_injection_travel});
}

/// Adds a hypothesis. Of more than kMaxBumps the weakest is removed; null if that is the new one.
CalibrationBump* BumpNetwork::insertBump(const CalibrationBump& bump) {
  auto& bumps = state_.calibration;
  if (bumps.size() == kMaxBumps) {
    const auto weakest = std::ranges::min_element(bumps, {}, &CalibrationBump::energy);
    if (weakest->energy >= bump.energy) return nullptr;
    note(*weakest, Fate::Displaced);
    bumps.erase(weakest);
  }
  bumps.push_back(bump);
  return &bumps.back();
}

void BumpNetwork::startPart() {
  if (!settings_.localise) state_.history.startPart();
  state_.part = state_.parts++;
  ++state_.stretch;
  state_.integrator.covariance.setZero();
  state_.integrator.height_variance = 0;
  state_.stretch_start = state_.integrator;
  state_.calibration.clear();
  // The share of right views was counted on another part of the path.
  state_.views = state_.right = 0;
}

LearnedPattern BumpNetwork::currentPattern() const {
  return {state_.integrator.centre,
          state_.part,
          state_.stretch,
          covarianceInPart(),
          state_.integrator.height_variance + state_.stretch_start.height_variance,
          state_.integrator.errors,
          state_.history.last()};
}

/// The errors of a path to a pose are common to what is fixed to that pose: they cancel.
PathErrors BumpNetwork::errorsBetween(const Bump& here, const Bump& there) const {
  const Eigen::Vector3d back = code_.difference(there.centre, here.centre);
  return here.errors - displaced(there.errors, back.head<2>());
}

BumpNetwork::Apart BumpNetwork::apart(const Bump& here, const Bump& there, const PathErrors& errors,
                                      const ErrorEstimate& estimate) const {
  Apart apart;
  apart.shift = errors.effect * estimate.mean - errors.applied;
  apart.difference = code_.difference(here.centre, there.centre) - apart.shift;
  apart.difference.z() = wrapAngle(apart.difference.z());
  apart.covariance = errors.effect * estimate.covariance * errors.effect.transpose();
  return apart;
}

/// Fuses a view with the bump; its errors become those of both, in proportion.
void BumpNetwork::fuse(Bump& bump, const Bump& seen) const {
  const PathErrors between = errorsBetween(bump, seen);
  const Apart away = apart(bump, seen, between, state_.path.mixed);
  code_.shift(bump.centre, away.shift);
  bump.covariance += away.covariance;
  const Eigen::Matrix3d keep = seen.covariance * (bump.covariance + seen.covariance).inverse();
  const ErrorEffect own = keep * between.effect;
  const Eigen::Vector3d back = code_.difference(seen.centre, bump.centre);
  code_.fuse(bump, seen.centre, seen.covariance, seen.height_variance);
  bump.errors =
      displaced(seen.errors, back.head<2>()) + PathErrors{own, own * state_.path.mixed.mean};
}

/// A step of each filter by the accepted bump, less the farther off it is (Student's t), and Bayes'
/// rule for their weights and for the factor of noise.
void BumpNetwork::recalibrate(const Bump& winner, const LearnedPattern& learned) {
  RunningCalibration& path = state_.path;
  const PathErrors errors = errorsBetween(state_.integrator, winner);
  const Eigen::Matrix3d noise = uncertainty(learned);
  const Apart mixed = apart(state_.integrator, winner, errors, path.mixed);
  for (int k = 0; k < RunningCalibration::kFactors; ++k) {
    const double ratio = RunningCalibration::factorAt(k) / path.noise;
    const Eigen::Matrix3d S = ratio * ratio * noise + winner.covariance + mixed.covariance;
    path.log_factors[k] += logStudent(squaredMahalanobis(mixed.difference, S), S, settings_.tail);
  }
  for (ErrorEstimate& estimate : path.estimates) {
    const TracedLoop loop = judge(estimate, winner, learned, errors, noise + winner.covariance);
    estimate = loop.estimate;
    estimate.log_weight += std::log(std::max(loop.density, 1e-300));
  }
  path.mix();
}

/// What a loop says of the steady errors. They are traced where they leave the heading open.
TracedLoop BumpNetwork::judge(const ErrorEstimate& estimate, const Bump& seen,
                              const LearnedPattern& learned, const PathErrors& errors,
                              const Eigen::Matrix3d& noise) const {
  const Apart away = apart(state_.integrator, seen, errors, estimate);
  if (away.covariance(2, 2) > kOpenTurn * kOpenTurn && !settings_.localise) {
    TracedLoop loop = traceLoop(
        state_.history, estimate,
        {learned.piece, fromPiece(learned.piece, seen.centre), seen.covariance}, settings_.tail);
    // A way that is bent until it closes says little for a place, however well it closes.
    loop.density = std::min(loop.density, std::exp(kMostBent + logDensityOfLookAlike()));
    return loop;
  }
  const Eigen::Matrix3d S = noise + away.covariance;
  const double squared = squaredMahalanobis(away.difference, S);
  const double weight = std::min(1.0, (settings_.tail + 3) / (settings_.tail + squared));
  TracedLoop loop = {estimate, std::exp(logStudent(squared, S, settings_.tail))};
  update(loop.estimate, errors.effect, away.difference, noise / weight);
  return loop;
}

/// Pose of a pattern in the axes of where the piece begins.
PlanarPose BumpNetwork::fromPiece(std::int64_t piece, const FiringPattern& pattern) const {
  return code_.between(patternAt(state_.history.beginOf(piece)), pattern);
}

/// Traces the path again, if what is known of its errors now gives it another shape.
void BumpNetwork::retrace(Recalibration& calibrated) {
  const PathErrors& errors = state_.integrator.errors;
  const double turn = (errors.effect * state_.path.mixed.mean - errors.applied).z();
  if (std::abs(turn) < kLinearTurn) return;
  calibrated.traced = state_.history.trace(state_.path.mixed.mean);
  for (const PathPiece& piece : state_.history.pieces()) calibrated.before.push_back(piece.begin);
  state_.history.accept(calibrated.traced);
  state_.explored_min = state_.explored_max = Eigen::Vector2d::Zero();
  for (const Traced& traced : calibrated.traced) {
    const Eigen::Vector2d there(traced.pose.x, traced.pose.y);
    state_.explored_min = state_.explored_min.cwiseMin(there);
    state_.explored_max = state_.explored_max.cwiseMax(there);
  }
}

void BumpNetwork::moveWithPath(const Recalibration& calibrated, LearnedPattern& learned) const {
  if (calibrated.traced.empty()) return;
  const auto k = static_cast<std::size_t>(learned.piece);
  const FiringPattern from = patternAt(calibrated.before[k]);
  Traced there = calibrated.traced[k];
  const PlanarPose offset = code_.between(from, learned.pattern);
  there.move(offset, Eigen::Matrix3d::Zero(), {});
  const Residues heights = learned.pattern.heights;
  learned.pattern = patternAt(there.pose);
  learned.pattern.heights = heights;
  learned.covariance = there.covariance;
  learned.errors = there.errors;
}

/// Covariance of the integrator relative to the origin of its part.
Eigen::Matrix3d BumpNetwork::covarianceInPart() const {
  return state_.integrator.covariance +
         propagatedTo(state_.integrator.centre, state_.stretch_start);
}

double BumpNetwork::shareOfRightViews() const {
  const double share =
      (settings_.prior * settings_.prior_views + static_cast<double>(state_.right)) /
      (settings_.prior_views + static_cast<double>(state_.views));
  return std::clamp(share, kMinPrior, kMaxPrior);
}

/// Log density of the pose if the view is a look-alike: uniform over explored area and heading.
double BumpNetwork::logDensityOfLookAlike() const {
  const Eigen::Vector2d sides =
      state_.explored_max - state_.explored_min + Eigen::Vector2d::Constant(2 * kMargin);
  return -std::log(kTurn * std::max(sides.prod(), kMinArea));
}

/// Covariance of the bump's centre, propagated to another pattern by displacementJacobian().
Eigen::Matrix3d BumpNetwork::propagatedTo(const FiringPattern& there, const Bump& bump) const {
  const Eigen::Matrix3d J = displacementJacobian(code_.difference(bump.centre, there).head<2>());
  return J * bump.covariance * J.transpose();
}

/// Covariance of the relative pose between where the view was learned and now. Along one stretch
/// of the path it is the difference of the covariances at its two ends, because the later one
/// contains the earlier one. For a view of an earlier stretch it is the sum of two terms, through
/// the beginning of the present stretch.
Eigen::Matrix3d BumpNetwork::uncertainty(const LearnedPattern& learned) const {
  const Bump then = {learned.pattern, learned.covariance};
  if (learned.stretch == state_.stretch) {
    return absolute(covarianceInPart() - propagatedTo(state_.integrator.centre, then));
  }
  return state_.integrator.covariance +
         absolute(learned.covariance - propagatedTo(learned.pattern, state_.stretch_start));
}

/// Variance of the difference in height between the same two places, m^2.
double BumpNetwork::heightUncertainty(const LearnedPattern& learned) const {
  const double start = state_.stretch_start.height_variance;
  const double here = state_.integrator.height_variance;
  if (learned.stretch == state_.stretch) return std::abs(here + start - learned.height_variance);
  return here + std::abs(learned.height_variance - start);
}

double BumpNetwork::heightMisfit(const LearnedPattern& learned, const Climb& climb) const {
  if (code_.height().modules() == 0 || learned.part != state_.part) return 0;
  const double off = code_.climb(state_.integrator.centre, learned.pattern) + climb.metres;
  const double variance = heightUncertainty(learned) + climb.variance + code_.height().readout();
  const double misfit = off * off / variance;
  return misfit > kSameStorey ? std::numeric_limits<double>::infinity() : misfit;
}

bool BumpNetwork::onOneStorey(const LearnedPattern& a, const LearnedPattern& b) const {
  const double off = code_.climb(a.pattern, b.pattern);
  const double variance =
      std::abs(a.height_variance - b.height_variance) + code_.height().readout();
  return off * off <= kSameStorey * variance;
}

/// Log-likelihood ratio, right view against look-alike, of a view that no bump agrees with. A
/// difference in height only lowers it.
double BumpNetwork::logRatioOfNewBump(const LearnedPattern& learned, const Bump& seen) const {
  // A density ratio needs a predicted position, which is unknown here. The parameter `prior` is
  // used a second time, as the probability that the robot is in the mapped area at all.
  if (learned.part != state_.part) return std::log(settings_.prior);
  const Bump& here = state_.integrator;
  const PathErrors errors = errorsBetween(here, seen);
  const Eigen::Matrix3d noise = uncertainty(learned) + seen.covariance;
  double density = 0;
  for (const ErrorEstimate& estimate : state_.path.estimates) {
    density +=
        std::exp(estimate.log_weight) * judge(estimate, seen, learned, errors, noise).density;
  }
  double ratio = std::log(std::max(density, 1e-300)) - logDensityOfLookAlike();
  if (settings_.localise) ratio = std::max(ratio, std::log(settings_.prior));
  return ratio - 0.5 * squaredClimb(code_.climb(here.centre, seen.centre),
                                    heightUncertainty(learned) + seen.height_variance);
}

CalibrationBump* BumpNetwork::findAgreeingBump(const Bump& seen, std::int64_t part,
                                               double& log_density) {
  CalibrationBump* best = nullptr;
  for (CalibrationBump& c : state_.calibration) {
    if (c.part != part) continue;
    const Apart away = apart(c.bump, seen, errorsBetween(c.bump, seen), state_.path.mixed);
    const Eigen::Vector3d& difference = away.difference;
    const Eigen::Matrix3d sum = c.bump.covariance + seen.covariance + away.covariance;
    if (squaredMahalanobis(difference, sum) > kAgrees) continue;
    if (squaredClimb(code_.climb(c.bump.centre, seen.centre),
                     c.bump.height_variance + seen.height_variance) > kSameStorey)
      continue;
    const double density = logGaussian(difference, sum);
    if (best != nullptr && density <= log_density) continue;
    best = &c;
    log_density = density;
  }
  return best;
}

Recalibration BumpNetwork::inject(const LearnedPattern& learned, const PlanarPose& offset,
                                  const Eigen::Matrix3d& measured, const Climb& climb) {
  Bump seen = {code_.displaced(learned.pattern, offset, climb.metres)};
  seen.covariance = turned(measured, seen.centre.heading) + code_.readout();
  seen.height_variance = climb.variance + code_.height().readout();
  const Eigen::Vector3d off = code_.difference(learned.pattern, seen.centre);
  seen.errors = displaced(learned.errors, off.head<2>());
  ++state_.views;
  double log_density = 0;
  CalibrationBump* bump = findAgreeingBump(seen, learned.part, log_density);
  const Fate fate = bump != nullptr ? Fate::Grew : Fate::Born;
  const double before = bump != nullptr ? bump->energy : 0;
  if (bump != nullptr) {
    const double fresh =
        std::min(1.0, (state_.travel - bump->last_injection_travel) / settings_.view_spacing);
    const double ratio = settings_.injection * (log_density - logDensityOfLookAlike());
    bump->energy += fresh * std::min(ratio, settings_.agreement);
    fuse(bump->bump, seen);
  } else {
    const double odds = std::log(shareOfRightViews() / (1 - shareOfRightViews()));
    const double energy = odds + settings_.injection * logRatioOfNewBump(learned, seen);
    bump = insertBump({state_.bumps, seen, energy, learned.part, 0, state_.travel});
    if (bump == nullptr) return {};
    ++state_.bumps;
  }
  ++bump->views;
  const bool wins = share(bump->energy) > settings_.threshold;
  note(*bump, wins ? Fate::Accepted : fate, bump->energy - before);
  bump->last_injection_travel = state_.travel;
  Recalibration result;
  result.bump = bump->id;
  if (!wins) return result;
  const CalibrationBump winner = *bump;
  return accept(winner, learned);
}

/// Moves the integrator to the bump; a stretch of the path begins. What is known of the path's
/// errors then may move all patterns. A bump in another part of the path says nothing of them.
void BumpNetwork::arriveAt(const Bump& bump, LearnedPattern learned, Recalibration& calibrated) {
  Bump here = bump;
  const bool joins = calibrated.joined_part >= 0;
  const bool learns = settings_.recalibrate && !settings_.localise;
  if (learns && !joins) {
    const PlanarPose offset = code_.between(learned.pattern, bump.centre);
    const double heading = bump.centre.heading;
    recalibrate(bump, learned);
    retrace(calibrated);
    if (!calibrated.traced.empty()) {
      moveWithPath(calibrated, learned);
      const Residues heights = here.centre.heights;
      here.centre = code_.displaced(learned.pattern, offset);
      here.centre.heights = heights;
      const Eigen::Vector2d away = code_.difference(learned.pattern, here.centre).head<2>();
      here.errors = displaced(learned.errors, away);
      here.covariance = turned(here.covariance, here.centre.heading - heading);
    }
  }
  if (learns) {
    const PlanarPose offset = fromPiece(learned.piece, here.centre);
    const Eigen::Matrix3d covariance =
        turned(here.covariance, -state_.history.beginOf(learned.piece).theta);
    if (joins) state_.history.join(learned.piece, offset, covariance);
    state_.history.jump(learned.piece, offset, covariance);
  }
  state_.integrator = here;
  state_.stretch_start = {learned.pattern, learned.covariance, learned.height_variance};
}

/// Moves the integrator to the winner. A new stretch of the path begins.
Recalibration BumpNetwork::accept(const CalibrationBump& winner, const LearnedPattern& learned) {
  Recalibration calibrated;
  calibrated.bump = winner.id;
  calibrated.accepted = true;
  calibrated.share = share(winner.energy);
  calibrated.part = winner.part;
  calibrated.from = state_.integrator;
  calibrated.to = winner.bump;
  calibrated.views = winner.views;
  calibrated.origin = learned.covariance;
  calibrated.origin_height = learned.height_variance;
  if (winner.part != state_.part) calibrated.joined_part = state_.part;
  arriveAt(winner.bump, learned, calibrated);
  state_.part = winner.part;
  ++state_.stretch;
  state_.right += winner.views;
  for (const CalibrationBump& other : state_.calibration) {
    if (other.id != winner.id) note(other, Fate::Displaced);
  }
  state_.calibration.clear();
  return calibrated;
}

void BumpNetwork::follow(const Recalibration& calibrated, LearnedPattern& learned) const {
  moveWithPath(calibrated, learned);
  if (learned.part != calibrated.joined_part) return;
  const FiringPattern& from = calibrated.from.centre;
  const FiringPattern& to = calibrated.to.centre;
  const Eigen::Vector2d before = code_.difference(from, learned.pattern).head<2>();
  learned.pattern =
      code_.displaced(to, code_.between(from, learned.pattern), code_.climb(from, learned.pattern));
  const Eigen::Vector2d after = code_.difference(to, learned.pattern).head<2>();
  learned.errors =
      displaced(calibrated.to.errors, after) +
      turned(learned.errors - displaced(calibrated.from.errors, before), to.heading - from.heading);
  learned.covariance += calibrated.origin;
  learned.height_variance += calibrated.origin_height;
  learned.part = calibrated.part;
}

double BumpNetwork::share(double energy) const {
  double rivals = std::exp(-energy);
  for (const CalibrationBump& c : state_.calibration) rivals += std::exp(c.energy - energy);
  return 1 / rivals;
}

}  // namespace tolman::bayesian_attractor
