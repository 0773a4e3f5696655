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
using Stretches = std::vector<Stretch>;

Stretch stretchBetween(const Matches& matches, std::size_t first, std::size_t last);
/// Consecutive stretches of `steps` tracked pairs, each in one piece of the path.
Stretches stretches(const Matches& matches, std::size_t steps);
/// Numbers of steps over which motions are compared: of a 400th, a 100th and a 25th of the path.
std::vector<std::size_t> stepCounts(const Matches& matches);

/// By stretch: how the estimated motion differs from the true one.
struct StepSeries {
  Stretches stretches;
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
Eigen::Matrix3d bestAxes(const Stretches& motions, double determinant);
/// The motions of the camera, if the truth's body has these axes and is at `arm` in it.
Stretches seenFrom(Stretches motions, const Eigen::Matrix3d& axes, const Eigen::Vector3d& arm);

struct ClockOffset {
  double seconds = 0;
  double sigma = 0;
};
/// What to add to the stamp of an estimated pose to find the truth that turns as it does. From
/// rates of turning: the offset with the smallest ATE depends on drift. `truth` is whole; the
/// matches have some of its poses. None for too few motions.
std::optional<ClockOffset> clockOffset(const Trajectory& truth, const Matches& matches,
                                       double longest_s = 2);
/// The matches with the truth `offset` seconds later; pairs beyond its ends count as not tracked.
Matches delayed(const Trajectory& truth, Matches matches, double offset);

}  // namespace tolman::evaluation
