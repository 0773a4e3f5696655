// SPDX-License-Identifier: BSD-3-Clause
// The frames of a bag, and what was measured beside them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bag.hpp"
#include "side_measurements.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// "1749315324.903 s".
std::string secondsText(std::int64_t ns);

/// Reads all messages of the topics that are not null. `frames_ns`: the first and the last time of
/// the run's images; odometry without any of them in its times is not used. Damaged messages, and
/// such odometry, go to `findings`.
Result<SideMeasurements> loadMeasurements(Bag& bag, const BagTopic* imu, const BagTopic* odometry,
                                          std::pair<std::int64_t, std::int64_t> frames_ns,
                                          FindingCollector& findings);

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
