// SPDX-License-Identifier: BSD-3-Clause
// Points from one stereo pair, by block matching at a reduced size.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "structure_grid.hpp"
#include "tolman/geometry.hpp"
#include "tolman/records.hpp"

namespace tolman::view_sequences {

/// A point in camera axes, cm: within 327 m.
using CentimetrePoint = Eigen::Matrix<std::int16_t, 3, 1>;

class StereoPoints {
 public:
  explicit StereoPoints(const CameraRig& rig);

  /// A calibrated stereo pair whose images are wide enough.
  bool canMeasure() const { return can_measure_; }
  /// Points at depths from 3 to 25 m and within 20 m to the sides, about 2,000 in a street; empty
  /// for images without texture.
  std::vector<CentimetrePoint> pointsOf(const Frame& frame) const;

 private:
  double scale_ = 1;    ///< size of the matched images relative to the rig's
  Pinhole pinhole_;     ///< of the matched images
  double product_ = 0;  ///< focal length times baseline, px m
  int disparities_ = 0;
  bool can_measure_ = false;
};

// 3D points seen on the last 30 m of path, put together with the motions of odometry.

class StreetPoints {
 public:
  /// Adds the motion from the previous frame.
  void move(const Eigen::Isometry3d& T_previous_current);
  /// Adds the points of the current frame, in its camera axes; `path`: m driven so far.
  void add(std::vector<CentimetrePoint> points, double path);
  /// Whether the points of the frame at `path` (m) are needed: once per metre.
  bool wantsPoints(double path) const;
  /// Removes all points; to be called when the pose becomes unknown.
  void restart();

  /// The grid of point counts around the camera, after a rotation of the points about its y axis
  /// by `yaw` (rad, positive to the left). Empty before 15 m of path, or with too few points.
  std::optional<StructureLevels> levels(double yaw = 0) const;

  /// Pose of the current camera relative to the camera at the start or the last restart().
  const Eigen::Isometry3d& pose() const { return T_start_camera_; }

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  /// The points of one frame.
  struct Patch {
    double path = 0;
    Eigen::Isometry3d T_start_camera = Eigen::Isometry3d::Identity();
    std::vector<CentimetrePoint> points;
  };

  Eigen::Isometry3d T_start_camera_ = Eigen::Isometry3d::Identity();  ///< now
  std::deque<Patch> patches_;                                         ///< the oldest first
};

}  // namespace tolman::view_sequences
