// SPDX-License-Identifier: BSD-3-Clause
// The frames that odometry was given, and whether the durations that it answers agree with their
// stamps.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

class MotionTimes {
 public:
  /// `motion` is an answer to `frame`. Its `dt` must be within a factor of ten of the time since
  /// the frame before: some plugins take a nominal rate. That is the last frame that odometry was
  /// given, or, for a plugin that failed at it, the last one that it answered.
  Status check(const Frame& frame, const Motion& motion) const;
  /// To be called after each call, `answered` or not.
  void add(const Frame& frame, bool answered);
  /// The last frame; the largest number where there was none.
  std::int64_t lastFrame() const { return last_frame_; }
  /// False for a frame between the first and the last that was left out: realtime drops frames.
  bool wasGiven(std::int64_t frame) const;

 private:
  /// Numbers of frames that were left out, both ends included.
  struct Gap {
    std::int64_t first;
    std::int64_t last;
  };
  std::vector<Gap> gaps_;  // ascending
  std::int64_t last_frame_ = INT64_MAX;
  std::int64_t given_ns_ = 0;
  std::int64_t answered_ns_ = 0;
};

}  // namespace tolman::host
