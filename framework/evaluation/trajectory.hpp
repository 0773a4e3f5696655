// SPDX-License-Identifier: BSD-3-Clause
// A trajectory: camera poses in the order of time.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::evaluation {

/// One pose. Frames grow strictly within a trajectory, and stamps too where they are known.
struct TrajectoryPose {
  std::int64_t frame = 0;
  std::int64_t stamp_ns = 0;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  bool tracked = true;      ///< false: odometry was lost or initialising
  std::size_t session = 0;  ///< how the robot came from one session to the next is not known
};
using Trajectory = std::vector<TrajectoryPose>;

/// Whether times are known: KITTI files have none, and all their stamps are 0.
bool hasStamps(const Trajectory& trajectory);
/// Whether orientations are known: files with positions alone leave them all equal.
bool hasOrientations(const Trajectory& trajectory);

/// Median of the times between poses, ns (of an even number of them the smaller middle one).
std::int64_t medianStep(const Trajectory& trajectory);

/// The pose at a time: positions between two poses are linear, rotations slerp.
struct PoseAt {
  Eigen::Isometry3d T_world_camera;
  std::size_t before = 0;  ///< index of the pose at or before this time
  double share = 0;        ///< of the way from it to the next one
};
/// None before the first and after the last pose, and inside gaps longer than `longest_gap_ns`.
std::optional<PoseAt> poseAt(
    const Trajectory& trajectory, std::int64_t stamp_ns,
    std::int64_t longest_gap_ns = std::numeric_limits<std::int64_t>::max());

/// T times each pose: the trajectory seen from another world.
Trajectory movedBy(const Eigen::Isometry3d& T, Trajectory trajectory);
/// Each pose times T: the trajectory of another body on the same vehicle.
Trajectory ofBody(Trajectory trajectory, const Eigen::Isometry3d& T_camera_body);

/// One column per pose, m.
Eigen::Matrix3Xd positions(const Trajectory& trajectory);
/// The same, relative to their mean.
Eigen::Matrix3Xd centredPositions(const Trajectory& trajectory);
/// Size of the box around the positions, along the axes of the first pose, m.
Eigen::Vector3d extentFromFirst(const Trajectory& trajectory);

/// Distance travelled up to each pose, m, from 0; nothing from one session to the next.
std::vector<double> distances(const Trajectory& trajectory);

/// Length of the whole path, m; 0 for fewer than two poses.
double pathLength(const Trajectory& trajectory);

// Reads trajectory files: TUM, KITTI, KITTI-360, EuRoC, and tables with named columns. Errors are
// InvalidInput and start with file:line.

/// A line of names before the numbers names the columns ("stamp_ns, x, y, z, qw, ..."; a comment
/// does so if it has as many). Without it their count determines the format: 8 are TUM (stamp, s;
/// position, m; quaternion, w last), 12 KITTI (rows of T_world_camera), 4 a stamp and a position,
/// 13 and 17 a frame and its matrix (KITTI-360). Stamps of 16 and more digits are ns, as in EuRoC's
/// tables, where w comes first.
///
/// Stamps must grow; they are read exactly to the nanosecond. Without frames, these are counted
/// from 0; without stamps, these are 0. Positions alone have equal orientations. Matrices become
/// exact rotations, unless `as_written`.
Result<Trajectory> readTrajectory(const std::filesystem::path& file, bool as_written = false);

}  // namespace tolman::evaluation
