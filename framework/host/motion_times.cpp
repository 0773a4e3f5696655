// SPDX-License-Identifier: BSD-3-Clause
#include "host/motion_times.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tolman::host {

Status MotionTimes::check(const Frame& frame, const Motion& motion) const {
  constexpr double kFactor = 10;
  if (motion.dt < 0) return Status::failed(fmt::format("'dt' is {:g} s", motion.dt));
  if (last_frame_ == INT64_MAX) return Status::ok();
  const double shortest = 1e-9 * static_cast<double>(frame.stamp_ns - given_ns_);
  const double longest = 1e-9 * static_cast<double>(frame.stamp_ns - answered_ns_);
  const bool unknown = motion.state == TrackingState::Initialising;  // a new process has dt = 0
  if (motion.dt <= kFactor * longest && (unknown || kFactor * motion.dt >= shortest)) {
    return Status::ok();
  }
  return Status::failed(fmt::format(
      "'dt' is {:g} s, the stamps say {:g} s; see setPlanarVelocity()", motion.dt, shortest));
}

void MotionTimes::add(const Frame& frame, bool answered) {
  if (answered || last_frame_ == INT64_MAX) answered_ns_ = frame.stamp_ns;
  if (last_frame_ < frame.frame - 1) gaps_.push_back({last_frame_ + 1, frame.frame - 1});
  given_ns_ = frame.stamp_ns;
  last_frame_ = frame.frame;
}

bool MotionTimes::wasGiven(std::int64_t frame) const {
  const auto next = std::ranges::upper_bound(gaps_, frame, {}, &Gap::first);
  return next == gaps_.begin() || std::prev(next)->last < frame;
}

}  // namespace tolman::host
