// SPDX-License-Identifier: BSD-3-Clause
// Measurements beside the images, and the frames that they belong to.
//
// Other measurements of a bag: angular velocity and acceleration, and planar odometry.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bag.hpp"
#include "messages.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// "1749315324.903 s".
std::string secondsText(std::int64_t ns);

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

// Frames from messages of several topics, joined by their stamps.

/// Messages of one frame, as indices into the topics' lists.
struct FrameRow {
  std::size_t left = 0;
  std::size_t right = 0;             ///< with a pair only
  std::optional<std::size_t> depth;  ///< the nearest within the tolerance
};

struct FrameTable {
  std::vector<FrameRow> rows;     ///< by the stamp of the left image
  std::size_t left_alone = 0;     ///< number of left images without a right one, which are left out
  std::size_t right_alone = 0;    ///< number of right images without a left one
  std::size_t without_depth = 0;  ///< number of rows, where a depth topic is chosen
};

/// For each message of `left` the one of `others` with the nearest stamp, if within the tolerance;
/// none is used twice. Both must be sorted by stamp.
std::vector<std::optional<std::size_t>> matchStamps(const std::vector<BagMessage>& left,
                                                    const std::vector<BagMessage>& others,
                                                    std::int64_t tolerance_ns);

/// InvalidInput if no left image has a right one, or no frame a depth image; the message contains
/// their difference in time.
Result<FrameTable> makeFrameTable(const BagTopic& left, const BagTopic* right,
                                  const BagTopic* depth, std::int64_t tolerance_ns);

}  // namespace tolman::ros_bag
