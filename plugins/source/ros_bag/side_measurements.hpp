// SPDX-License-Identifier: BSD-3-Clause
// Other measurements of a bag: angular velocity and acceleration, and planar odometry.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bag.hpp"
#include "messages.hpp"
#include "odometry_coverage.hpp"
#include "odometry_restart.hpp"
#include "odometry_speeds.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"

namespace tolman::ros_bag {

class SideMeasurements {
 public:
  /// Reads all messages of the topics that are not null. Damaged ones are counted.
  Status load(Bag& bag, const BagTopic* imu, const BagTopic* odometry);
  std::size_t damaged() const { return damaged_; }
  /// "of /imu with the stamp 5000000000 ns (message 3)"; empty if none is damaged.
  const std::string& firstDamaged() const { return first_damaged_; }
  /// Compares the times of the odometry with those of the frames, in the order of the run.
  /// `problems` gets a text for each kind of frames without a measured motion, one if the
  /// poses begin again, and one if poses and velocities contradict each other. InvalidInput if all
  /// its times lie before or after the frames; it is not used then. No text contains the topic.
  Status judgeOdometry(const std::vector<std::int64_t>& frames_ns,
                       std::vector<std::string>& problems);

  /// Appends, for a frame at `stamp_ns` after one at `previous_ns` (the same at the first):
  /// imu.angular_velocity (rad/s) and imu.linear_acceleration (m/s^2), the means since then in the
  /// axes of the sensor, imu.samples, and motion.planar (m, m, rad) since then. If the odometry
  /// does not measure the motion to every frame, also motion.lost: 1 where motion.planar is a
  /// guess, a straight line through a hole, and standstill before the first and after the last
  /// message.
  void measure(std::int64_t previous_ns, std::int64_t stamp_ns,
               std::vector<NamedArray>& sensors) const;
  /// Descriptions of these arrays.
  void describe(std::vector<ArrayInfo>& arrays) const;

 private:
  struct Pose {
    std::int64_t stamp_ns = 0;
    PlanarPose pose;
  };
  void measureImu(std::int64_t begin_ns, std::int64_t end_ns,
                  std::vector<NamedArray>& sensors) const;
  void tellDamaged(const BagTopic& topic, const BagMessage& message);
  /// Linear interpolation in time between measured poses; constant before the first and after the
  /// last.
  PlanarPose poseAt(std::int64_t stamp_ns) const;

  bool has_imu_ = false;
  std::vector<ImuMessage> imu_;  ///< by stamp
  std::vector<Pose> poses_;      ///< by stamp
  OdometryCoverage coverage_;
  OdometrySpeeds speeds_;
  OdometryRestart restart_;
  bool tells_lost_ = false;  ///< a frame's motion is not measured
  std::size_t damaged_ = 0;
  std::string first_damaged_;
};

}  // namespace tolman::ros_bag
