// SPDX-License-Identifier: BSD-3-Clause
// Where and when the truth is measured, against the camera of the estimate: the axes and the point
// of its body, and the offset of its clock.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "evaluation/step_series.hpp"

namespace tolman::evaluation {

/// The body that the truth is measured of, seen from the camera.
struct Extrinsic {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  ///< from the axes of the body to the camera's
  Eigen::Vector3d arm = Eigen::Vector3d::Zero();    ///< m, of the truth's point in the camera
  Eigen::Vector3d sigma = Eigen::Vector3d::Zero();  ///< m; infinite where the path does not turn
};
/// From relative motions over a few frames: absolute poses, with their drift, give a wrong arm.
/// `with_axes`: R is estimated as well, else it is the identity.
Extrinsic extrinsicOf(const Matches& matches, bool with_axes);

/// The orthogonal matrix R of this determinant, 1 or -1, with the largest trace of products R'
/// (Arun et al. 1987).
Eigen::Matrix3d bestOrthogonal(const Eigen::Matrix3d& products, double determinant = 1);
/// The matrix of this determinant that takes the motions of the truth's body to those of the camera
/// best.
Eigen::Matrix3d bestAxes(const std::vector<Stretch>& motions, double determinant);

/// The truth's motions in other axes of its body.
std::vector<Stretch> turned(std::vector<Stretch> motions, const Eigen::Matrix3d& axes);
/// The motions of the camera, if the truth's point is at `arm` in it.
std::vector<Stretch> shifted(std::vector<Stretch> motions, const Eigen::Vector3d& arm);

/// Numbers of steps over which motions are compared: of a 400th, a 100th and a 25th of the path.
std::vector<std::size_t> stepCounts(const Matches& matches);

/// The truth at and between its poses. Times are s since its first pose, or frames where it has no
/// stamps.
class TruthOverTime {
 public:
  /// `by_stamp`: estimates have their own stamps, else those of the true poses they are matched
  /// with. `truth` is whole; the matches have some of its poses.
  TruthOverTime(const Trajectory& truth, const Matches& matches, bool by_stamp);
  bool inFrames() const { return in_frames_; }
  double periodOfPairs() const {
    return (pairs_.back() - pairs_.front()) / static_cast<double>(pairs_.size());
  }
  double duration() const { return times_.back(); }
  double timeOfPair(std::size_t i) const { return pairs_[i]; }
  /// Interpolated; none before the first and after the last true pose.
  std::optional<Eigen::Isometry3d> at(double time) const;

 private:
  const Trajectory& truth_;
  bool in_frames_;
  std::vector<double> times_;
  std::vector<double> pairs_;
};

/// What to add to the time of an estimated pose to find the time at which the truth turns as it
/// does. From the rates of turning: the offset with the smallest ATE depends on drift. None where
/// there are too few motions.
std::optional<double> clockOffset(const TruthOverTime& truth, const Matches& matches);

/// The matches with the truth `offset` later; pairs beyond its ends count as not tracked.
Matches delayed(const TruthOverTime& truth, Matches matches, double offset);

}  // namespace tolman::evaluation
