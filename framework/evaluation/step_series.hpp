// SPDX-License-Identifier: BSD-3-Clause
// True and estimated motion over the same short stretches of a path: one curve that shows where a
// trajectory is broken (a report draws it), and from which follow where and when the truth is
// measured, against the camera of the estimate: axes and point of its body, offset of its clock.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// Motions from pair `first` to pair `last`, each in the axes of its own body.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  Eigen::Isometry3d truth;
  Eigen::Isometry3d estimate;
};

Stretch stretchBetween(const Matches& matches, std::size_t first, std::size_t last);

/// Consecutive stretches of `steps` tracked pairs, each in one piece of the path.
std::vector<Stretch> stretches(const Matches& matches, std::size_t steps);

/// By stretch: how the estimated motion differs from the true one.
struct StepSeries {
  std::vector<Stretch> stretches;
  std::vector<std::int64_t> frames;  ///< of the true pose at the end
  std::vector<double> log_ratio;     ///< natural logarithm of estimated over true length
  std::vector<double> turn;          ///< angle between the two rotations, rad
};
/// A tenth of the usual length is added to both lengths: noise at a standstill is no ratio.
StepSeries stepSeries(const Matches& matches, std::size_t steps);

/// What breaks the curve: a truth or an estimate that stands still while the other moves, a jump or
/// a turn of the truth in a single step, an estimate that starts again at its origin, a change of
/// units. One sentence each, with the frames; nothing for noise without outliers.
std::vector<std::string> breaksOf(const Matches& matches);

/// The pairs at which the estimate starts again at its origin, as after a loss of tracking.
std::vector<std::size_t> restartsOf(const Matches& matches);

// Where and when the truth is measured, against the camera of the estimate: the axes and the point
// of its body, and the offset of its clock.

/// The body that the truth is measured of, seen from the camera.
struct Extrinsic {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< from the axes of the body to the camera's
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();    ///< m, of the truth's point in the camera
  Eigen::Vector3d sigma = Eigen::Vector3d::Zero();  ///< m; infinite where the path does not turn

  /// T_camera_body
  Eigen::Isometry3d pose() const { return Eigen::Translation3d(arm) * Eigen::Quaterniond(R); }
};
/// "x,y,z" (m) or "x,y,z,qx,qy,qz,qw", without sigmas. InvalidParameter for others.
Result<Extrinsic> parseBody(const std::string& text);
/// "(0.20 +- 0.01, 0.76 +- 0.09, unknown) m in the camera (x right, y down, z forward)".
std::string armText(const Extrinsic& extrinsic);
/// Null where not known.
nlohmann::ordered_json toJson(const Extrinsic& body);
/// From relative motions over a few frames: absolute poses, with their drift, give a wrong arm.
/// `with_axes`: R is estimated as well, else it is the identity.
Extrinsic extrinsicOf(const Matches& matches, bool with_axes);
/// With its axes if they differ from those of the camera by more than odometry's errors. None
/// where too few poses match, or the truth does not turn.
std::optional<Extrinsic> bodyOf(const Matches& matches);

/// The matrix of this determinant that turns the truth's motions to the camera's best.
Eigen::Matrix3d bestAxes(const std::vector<Stretch>& motions, double determinant);

/// The truth's motions in other axes of its body.
std::vector<Stretch> turned(std::vector<Stretch> motions, const Eigen::Matrix3d& axes);
/// The motions of the camera, if the truth's point is at `arm` in it.
std::vector<Stretch> shifted(std::vector<Stretch> motions, const Eigen::Vector3d& arm);

/// Numbers of steps over which motions are compared: of a 400th, a 100th and a 25th of the path.
std::vector<std::size_t> stepCounts(const Matches& matches);

/// The true poses at the times of the pairs. Times are s, or frames where the truth has no stamps.
class TruthOverTime {
 public:
  /// `by_stamp`: estimates have their own stamps, else those of the true poses they are matched
  /// with. `truth` is whole; the matches have some of its poses.
  TruthOverTime(Trajectory truth, const Matches& matches, bool by_stamp);
  bool inFrames() const { return in_frames_; }
  double periodOfPairs() const;
  double duration() const;
  /// The truth `offset` after pair `i`; none before its first and after its last pose.
  std::optional<PoseAt> at(std::size_t i, double offset) const;

 private:
  bool in_frames_;
  Trajectory truth_;                 ///< stamps are frames * 1e9 where it has none
  std::vector<std::int64_t> pairs_;  ///< ns
};

struct ClockOffset {
  double seconds = 0;  ///< or frames
  double sigma = 0;
};
/// What to add to the time of an estimated pose to find the truth that turns as it does. From rates
/// of turning: the offset with the smallest ATE depends on drift. None for too few motions.
std::optional<ClockOffset> clockOffset(const TruthOverTime& truth, const Matches& matches);

/// The matches with the truth `offset` later; pairs beyond its ends count as not tracked.
Matches delayed(const TruthOverTime& truth, Matches matches, double offset);

}  // namespace tolman::evaluation
