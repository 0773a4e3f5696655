// SPDX-License-Identifier: BSD-3-Clause
// The attractor network: one integrator bump and several calibration bumps that compete.
//
// The integrator bump follows path integration alone. Each calibration bump is a hypothesis that
// the robot is at a known place. Path integration moves and widens all bumps. A familiar view
// injects energy at the pattern that it is linked to: into the calibration bump that it agrees
// with, or as a new bump. Energies are in nats: log odds against the hypothesis of the integrator,
// whose energy is 0. A bump's share (posterior probability) is exp(E) over the sum of all bumps
// (normalisation; the paper's global inhibition). A bump whose share exceeds the threshold is
// accepted: the integrator moves to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tolman/records.hpp>
#include <vector>

#include "conjunctive_code.hpp"
#include "path_history.hpp"

namespace tolman::bayesian_attractor {

/// Maximum number of calibration bumps at a time; the weakest is removed first. Bounds the time.
inline constexpr std::size_t kMaxBumps = 16;

/// The defaults are those of the parameters; docs/method.md has their sources.
struct NetworkSettings {
  double period = 150;            ///< m, of the smallest grid module
  int modules = 4;                ///< grid modules
  double phase_sigma = 0.005;     ///< periods, standard deviation of the readout of a phase
  double height_period = 0;       ///< m, of the smallest vertical module; 0: a plane
  double drift_position = 0.06;   ///< m / sqrt(m)
  double drift_heading = 0.0012;  ///< rad / sqrt(m)
  double drift_height = 0.03;     ///< m / sqrt(m)
  double tail = 4;                ///< degrees of freedom of Student's t, of errors of odometry
  double prior = 0.05;            ///< share of familiar views that are right, before any was seen;
                        ///< also the probability that the robot is in the mapped area when
                        ///< its pose relative to it is unknown
  double prior_views = 100;  ///< weight of `prior`, as a number of views
  double injection = 1;      ///< factor on a view's log-likelihood ratio
  double agreement = 3;      ///< nats, most energy that a further view adds
  double inhibition = 0.02;  ///< nats / m, decay of every calibration bump; does not depend on the
                             ///< other bumps
  double threshold = 0.98;   ///< share (posterior probability) above which a bump is accepted
  double view_spacing = 5;   ///< m of travel after which the next view counts in full
  bool recalibrate = true;   ///< learn the errors of path integration
  /// The robot is in a map that stays as it is: nothing is learned of the path, and the robot may
  /// have been carried elsewhere at any time, with the probability `prior`.
  bool localise = false;
};

/// What a view was linked to when it was learned. A stretch is the piece of the path between two
/// accepted bumps.
struct LearnedPattern {
  FiringPattern pattern;
  std::int64_t part = 0;     ///< number of the part of the path (see BumpNetwork::startPart)
  std::int64_t stretch = 0;  ///< number of the stretch of the path
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< relative to its part's origin
  double height_variance = 0;                            ///< m^2, likewise
  PathErrors errors = {};                                ///< likewise
  std::int64_t piece = 0;                                ///< of the path (PathHistory)
};

/// A hypothesis.
struct CalibrationBump {
  std::int64_t id = -1;  ///< 0, 1, 2 ... in the order of creation
  Bump bump;
  double energy = 0;                 ///< nats
  std::int64_t part = 0;             ///< part of the path that the bump is in
  std::int64_t views = 0;            ///< views that were injected into it
  double last_injection_travel = 0;  ///< m driven until the last injection
};

/// Everything in the network that changes from frame to frame.
struct NetworkState {
  Bump integrator;
  std::vector<CalibrationBump> calibration;
  std::int64_t bumps = 0;  ///< calibration bumps created so far
  std::int64_t part = 0;   ///< part of the path that the robot is in
  std::int64_t parts = 1;  ///< number of parts so far
  std::int64_t stretch = 0;
  Bump
      stretch_start;  ///< where the stretch begins, with its covariance from the origin of the part
  double travel = 0;  ///< m since the start
  Eigen::Vector2d explored_min =
      Eigen::Vector2d::Zero();  ///< explored rectangle, m from the origin
  Eigen::Vector2d explored_max = Eigen::Vector2d::Zero();
  std::int64_t views = 0;        ///< familiar views that were injected
  std::int64_t right = 0;        ///< of these, views of bumps that were accepted
  RunningCalibration path = {};  ///< what loops say of path integration
  PathHistory history = {};
};

/// Outcome of an injection: the bump that the view was injected into, and whether it was accepted.
/// A bump that is accepted in another part of the path joins the two parts: the patterns of one
/// move.
struct Recalibration {
  std::int64_t bump = -1;  ///< CalibrationBump::id; -1: too weak to create a bump
  bool accepted = false;
  double share = 0;               ///< posterior probability of the accepted bump
  std::int64_t views = 0;         ///< number of views injected into the accepted bump
  std::int64_t joined_part = -1;  ///< patterns of this part move; -1: no patterns move
  Bump from, to;                  ///< they move as `from` moves to `to`
  std::int64_t part = 0;          ///< the part that they belong to afterwards
  Eigen::Matrix3d origin = Eigen::Matrix3d::Zero();  ///< covariance to add to theirs
  double origin_height = 0;                          ///< m^2, variance to add to theirs
  /// Where the pieces of the path began, and where they begin since it was traced again.
  std::vector<PlanarPose> before = {};
  std::vector<Traced> traced = {};
};

class BumpNetwork {
 public:
  explicit BumpNetwork(const NetworkSettings& settings);

  /// Path integration by one step, in the robot's axes, over `seconds`. `reported`: its covariance,
  /// as odometry reports it.
  void integrate(const PlanarPose& step, const Eigen::Matrix3d& reported, const Climb& climb = {},
                 double seconds = 0);
  /// From here on the pose relative to the earlier path is unknown (a kidnapped robot): a new part
  /// of the path begins. Patterns of different parts have no known displacement until a loop joins
  /// the parts.
  void startPart();
  /// Injects a familiar view that puts the robot at `offset` from where the view was learned.
  Recalibration inject(const LearnedPattern& learned, const PlanarPose& offset,
                       const Eigen::Matrix3d& covariance, const Climb& climb = {});
  /// Squared difference of height, in variances, between path integration and the pose of a
  /// familiar view that was learned at `learned` and is seen from `climb` above it. It is infinite
  /// beyond three standard deviations, which means another storey.
  double heightMisfit(const LearnedPattern& learned, const Climb& climb) const;
  /// Whether the heights of two patterns of the same part agree.
  bool onOneStorey(const LearnedPattern& a, const LearnedPattern& b) const;
  /// The pattern of the integrator, to be linked to a view.
  LearnedPattern currentPattern() const;
  /// Moves a learned pattern with the path, where that was traced again, and with its part, where
  /// that was joined with another.
  void follow(const Recalibration& calibrated, LearnedPattern& learned) const;

  double share(double energy) const;
  const ConjunctiveCode& code() const { return code_; }
  const NetworkState& state() const { return state_; }
  /// What became of hypotheses since integrate(), for explanations.
  const std::vector<PlaceHypothesis>& changes() const { return changes_; }
  void restore(NetworkState state) { state_ = std::move(state); }

 private:
  /// Mean of a beta distribution that begins at `prior`.
  double shareOfRightViews() const;
  double logDensityOfLookAlike() const;
  double logRatioOfNewBump(const LearnedPattern& learned, const Bump& seen) const;
  /// Where one bump is from another near it, as path integration with the present calibration has
  /// it, and the part of its uncertainty that is due to the steady errors.
  struct Apart {
    Eigen::Vector3d difference;  ///< (x, y, heading)
    Eigen::Vector3d shift;       ///< of the first bump, by the present calibration
    Eigen::Matrix3d covariance;  ///< by steady errors alone
  };
  PathErrors errorsBetween(const Bump& here, const Bump& there) const;
  Apart apart(const Bump& here, const Bump& there, const PathErrors& errors,
              const ErrorEstimate& estimate) const;
  TracedLoop judge(const ErrorEstimate& estimate, const Bump& seen, const LearnedPattern& learned,
                   const PathErrors& errors, const Eigen::Matrix3d& noise) const;
  void fuse(Bump& bump, const Bump& seen) const;
  void recalibrate(const Bump& winner, const LearnedPattern& learned);
  void retrace(Recalibration& calibrated);
  PlanarPose fromPiece(std::int64_t piece, const FiringPattern& pattern) const;
  FiringPattern patternAt(const PlanarPose& pose) const {
    return code_.displaced(code_.origin(), pose);
  }
  void moveWithPath(const Recalibration& calibrated, LearnedPattern& learned) const;
  Eigen::Matrix3d covarianceInPart() const;
  Eigen::Matrix3d propagatedTo(const FiringPattern& there, const Bump& bump) const;
  Eigen::Matrix3d uncertainty(const LearnedPattern& learned) const;
  double heightUncertainty(const LearnedPattern& learned) const;
  CalibrationBump* findAgreeingBump(const Bump& seen, std::int64_t part, double& log_density);
  void arriveAt(const Bump& bump, LearnedPattern learned, Recalibration& calibrated);
  Recalibration accept(const CalibrationBump& winner, const LearnedPattern& learned);
  CalibrationBump* insertBump(const CalibrationBump& bump);
  void note(const CalibrationBump& bump, Fate fate, double change = 0);

  NetworkSettings settings_;
  ConjunctiveCode code_;
  NetworkState state_;
  std::vector<PlaceHypothesis> changes_;
};

}  // namespace tolman::bayesian_attractor
