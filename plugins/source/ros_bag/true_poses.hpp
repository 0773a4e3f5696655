// SPDX-License-Identifier: BSD-3-Clause
// True poses of a topic, at the times of the images.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "bag.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_bag {

/// What the parameter `truth` names: a topic, and of one with transforms also which of them.
struct TruthName {
  std::string topic, frame, child_frame;

  /// "/vicon/pose", or "/tf world camera".
  static TruthName of(const std::string& parameter);
};

class TruePoses {
 public:
  /// Reads all messages of the topic. InvalidParameter if the transform is not named, or not in it.
  /// Damaged messages, and a truth without any of the run's images in its times, go to `findings`.
  Status load(Bag& bag, const BagTopic& topic, const TruthName& name,
              std::pair<std::int64_t, std::int64_t> frames_ns, FindingCollector& findings);
  bool isEmpty() const { return poses_.empty(); }
  /// Seen from the first pose. None across a gap of more than 2.5 usual steps, at least 0.1 s.
  std::optional<Eigen::Isometry3d> at(std::int64_t stamp_ns) const;

 private:
  std::map<std::int64_t, Eigen::Isometry3d> poses_;  ///< by stamp
  std::int64_t longest_gap_ns_ = 0;
};

}  // namespace tolman::ros_bag
