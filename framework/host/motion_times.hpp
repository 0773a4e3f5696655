// SPDX-License-Identifier: BSD-3-Clause
// Whether the durations that odometry answers agree with the stamps of the frames.
#pragma once

#include <cstdint>

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

 private:
  std::int64_t last_frame_ = INT64_MAX;
  std::int64_t given_ns_ = 0;
  std::int64_t answered_ns_ = 0;
};

}  // namespace tolman::host
