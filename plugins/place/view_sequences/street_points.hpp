// SPDX-License-Identifier: BSD-3-Clause
// Points of the last 30 m of path, joined by the motions of odometry.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "stereo_points.hpp"
#include "structure_grid.hpp"
#include "tolman/geometry.hpp"

namespace tolman::view_sequences {

class StreetPoints {
 public:
  /// Adds the motion from the previous frame.
  void move(const Eigen::Isometry3d& T_previous_current);
  /// Adds the points of the present frame; `path` in m.
  void add(std::vector<CentimetrePoint> points, double path);
  /// Whether points are to be added at `path`: at most once a metre.
  bool wantsPoints(double path) const;
  /// Removes all points, because the pose is unknown.
  void restart();

  /// The grid around the present camera, with points turned about it by `yaw` (rad, positive to the
  /// left). Empty before 15 m of path, or with too few points.
  std::optional<StructureLevels> levels(double yaw = 0) const;

  /// Pose now, since restart().
  const Eigen::Isometry3d& pose() const { return T_start_camera_; }

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  struct Patch {
    double path = 0;
    Eigen::Isometry3d T_start_camera = Eigen::Isometry3d::Identity();
    std::vector<CentimetrePoint> points;
  };

  Eigen::Isometry3d T_start_camera_ = Eigen::Isometry3d::Identity();  ///< now
  std::deque<Patch> patches_;                                         ///< the oldest first
};

}  // namespace tolman::view_sequences
