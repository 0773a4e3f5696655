// SPDX-License-Identifier: BSD-3-Clause
// Other measurements of a bag: angular velocity and acceleration, and planar odometry.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "bag.hpp"
#include "messages.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"

namespace tolman::ros_bag {

class SideMeasurements {
 public:
  /// Reads all messages of the topics that are not null. `frames_ns`: the first and the last time
  /// of the run's images; odometry without any of them in its times is not used. Damaged messages,
  /// and such odometry, go to `findings`.
  Status load(Bag& bag, const BagTopic* imu, const BagTopic* odometry,
              std::pair<std::int64_t, std::int64_t> frames_ns, FindingCollector& findings);

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
  std::vector<ImuMessage> imu_;  ///< by stamp
  std::vector<Pose> poses_;      ///< by stamp
};

}  // namespace tolman::ros_bag
