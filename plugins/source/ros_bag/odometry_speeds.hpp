// SPDX-License-Identifier: BSD-3-Clause
// Whether the poses and the velocities of odometry messages have the same unit of length.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace tolman::ros_bag {

/// Compares the path along the poses with that of the velocities. Poses are taken at intervals of a
/// second, so that their noise does not make a path of a robot that stands.
class OdometrySpeeds {
 public:
  /// Messages by time, positions in m, speeds in m/s.
  void add(std::int64_t stamp_ns, const Eigen::Vector3d& position, double speed);
  /// Without the topic; empty if they agree, or if there are no velocities or no motion.
  std::string doubt() const;

 private:
  bool begun_ = false;
  std::int64_t last_ns_ = 0;   ///< of the last message
  std::int64_t point_ns_ = 0;  ///< of the last position on the path
  Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
  double by_poses_ = 0;   ///< m
  double by_speeds_ = 0;  ///< m, until `point_ns_`
  double since_ = 0;      ///< m, after it
};

}  // namespace tolman::ros_bag
