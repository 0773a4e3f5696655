// SPDX-License-Identifier: BSD-3-Clause
// Whether the poses of odometry messages begin again in the middle of a bag, as after a new start
// of the robot's driver.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>

namespace tolman::ros_bag {

/// Finds a position that is back at that of the first message in one step, which no robot drives.
class OdometryRestart {
 public:
  /// Positions (m) by time.
  void add(std::int64_t stamp_ns, const std::array<double, 3>& position);
  /// Without the topic; empty if none was found.
  std::string doubt() const;

 private:
  std::int64_t messages_ = 0;
  Eigen::Vector3d first_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d last_ = Eigen::Vector3d::Zero();
  double longest_step_ = 0;  ///< m, so far
  double jump_ = 0;          ///< m; 0 if none was found
  std::int64_t jump_ns_ = 0;
};

}  // namespace tolman::ros_bag
