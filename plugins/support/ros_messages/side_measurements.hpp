// SPDX-License-Identifier: BSD-3-Clause
// Measurements beside the images: angular velocity and acceleration, and planar odometry.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "messages.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"

namespace tolman::ros_messages {

class SideMeasurements {
 public:
  SideMeasurements() = default;
  SideMeasurements(bool has_imu, bool has_odometry)
      : has_imu_(has_imu), has_odometry_(has_odometry) {}

  /// Messages in the order of their times; earlier ones are left out. False: it is damaged.
  bool addImu(const Message& message, std::int64_t stamp_ns);
  bool addPose(const Message& message, std::int64_t stamp_ns);
  /// There is no odometry after all.
  void dropPoses();
  /// Forgets what no measurement from this time on needs.
  void forgetBefore(std::int64_t stamp_ns);

  bool hasPoses() const { return !poses_.empty(); }
  std::int64_t firstPoseNs() const { return poses_.front().stamp_ns; }
  std::int64_t lastPoseNs() const { return poses_.back().stamp_ns; }

  /// Appends, for a frame at `stamp_ns` after one at `previous_ns` (the same at the first):
  /// imu.angular_velocity (rad/s) and imu.linear_acceleration (m/s^2), the means since then in the
  /// axes of the sensor, imu.samples, and motion.planar (m, m, rad) since then with motion.lost: 1
  /// before the first and after the last message and in a pause of messages, where it is a guess.
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
  /// Linear interpolation in time between measured poses; constant before the first and after the
  /// last.
  PlanarPose poseAt(std::int64_t stamp_ns) const;
  bool isMeasured(std::int64_t begin_ns, std::int64_t end_ns) const;

  bool has_imu_ = false;
  bool has_odometry_ = false;
  std::vector<ImuMessage> imu_;  ///< by stamp
  std::vector<Pose> poses_;      ///< by stamp
};

}  // namespace tolman::ros_messages
