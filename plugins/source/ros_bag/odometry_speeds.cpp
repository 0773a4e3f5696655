// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_speeds.hpp"

#include <algorithm>

#include "bag_problems.hpp"

namespace tolman::ros_bag {

void OdometrySpeeds::add(std::int64_t stamp_ns, const Eigen::Vector3d& position, double speed) {
  constexpr std::int64_t kInterval_ns = 1'000'000'000;
  constexpr std::int64_t kHole_ns =
      kInterval_ns;  // chosen, not tuned; nothing is known of longer ones
  if (begun_ && stamp_ns - last_ns_ <= kHole_ns) {
    since_ += speed * static_cast<double>(stamp_ns - last_ns_) * 1e-9;
  } else {
    begun_ = true;
    since_ = 0;
    point_ = position;
    point_ns_ = stamp_ns;
  }
  last_ns_ = stamp_ns;
  if (stamp_ns - point_ns_ < kInterval_ns) return;
  by_poses_ += (position - point_).norm();
  by_speeds_ += since_;
  since_ = 0;
  point_ = position;
  point_ns_ = stamp_ns;
}

std::string OdometrySpeeds::doubt() const {
  constexpr double kFactor = 5;    // chosen, not tuned: dm and feet are not found, cm and mm are
  constexpr double kLeast = 0.02;  // m; chosen, not tuned: less may be noise of a robot that stands
  const double smaller = std::min(by_poses_, by_speeds_);
  if (smaller < kLeast || std::max(by_poses_, by_speeds_) < kFactor * smaller) return "";
  return "its poses make a path of " + shortNumber(by_poses_) + " m, and its velocities one of " +
         shortNumber(by_speeds_) + " m: are both in m and m/s?";
}

}  // namespace tolman::ros_bag
