// SPDX-License-Identifier: BSD-3-Clause
// Whether the path of the map's final poses is about as long as that of odometry.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/listener.hpp"
#include "tolman/records.hpp"

namespace tolman::pipeline {

/// A map corrects the path of odometry by little at each step: it spreads the error of a loop over
/// the loop. A map whose poses make a path of more than twice the length, and 1 m, moves frames
/// apart that odometry has joined.
class PathCheck {
 public:
  /// Call it with the motion of each frame that the map has taken, in order. Only tracked ones
  /// count: where tracking was lost, a correction may be of any size.
  void add(const Motion& motion);

  /// What is wrong with the final poses, which are in the order of frames; none if nothing is.
  std::optional<std::string> contradiction(std::span<const FramePose> poses) const;

 private:
  struct Step {
    std::int64_t frame = -1;  ///< that it leads to
    double length = 0;
  };
  std::vector<Step> steps_;
};

}  // namespace tolman::pipeline
