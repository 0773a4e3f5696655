// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_restart.hpp"

#include <algorithm>

#include "bag_problems.hpp"

namespace tolman::ros_bag {
namespace {

// Chosen, not tuned.
constexpr double kLeastJump = 0.1;  // m
constexpr double kLongStep = 10;    // times the longest step before
constexpr double kNearFirst = 0.1;  // of the jump

}  // namespace

void OdometryRestart::add(std::int64_t stamp_ns, const std::array<double, 3>& position) {
  const Eigen::Vector3d now(position.data());
  if (messages_++ == 0) first_ = last_ = now;
  const double step = (now - last_).norm();
  const bool is_back = (now - first_).norm() < kNearFirst * step;
  if (jump_ == 0 && step > kLeastJump && step > kLongStep * longest_step_ && is_back) {
    jump_ = step;
    jump_ns_ = stamp_ns;
  }
  longest_step_ = std::max(longest_step_, step);
  last_ = now;
}

std::string OdometryRestart::doubt() const {
  if (jump_ == 0) return "";
  return "its position is back where it began, " + shortNumber(jump_) +
         " m in one step, at the stamp " + std::to_string(jump_ns_) +
         " ns: was the robot's driver started again? Record the parts as bags of their own";
}

}  // namespace tolman::ros_bag
