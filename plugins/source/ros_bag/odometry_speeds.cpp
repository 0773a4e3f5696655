// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_speeds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bag_problems.hpp"
#include "tolman/geometry.hpp"

namespace tolman::ros_bag {
namespace {

// All limits are chosen, not tuned: real odometry agrees within per cents.
constexpr std::int64_t kInterval_ns = 1'000'000'000;
constexpr double kSlow = 0.05;      // m/s on average; less may be noise of a robot that stands
constexpr double kSlowTurn = 0.02;  // rad/s on average
constexpr double kFactor = 1.5;     // of lengths
constexpr double kAgreement = 0.5;  // mean cosine between the directions; part of the turn
constexpr double kLeastTurn = 0.3;  // rad

std::string degrees(double radians) {
  return shortNumber(radians * 180 / std::numbers::pi) + " degrees";
}

}  // namespace

void OdometrySpeeds::begin(const State& state) {
  start_ = state;
  moved_.fill(Eigen::Vector3d::Zero());
  turned_ = 0;
}

void OdometrySpeeds::add(std::int64_t stamp_ns, const ros_messages::OdometryMessage& message) {
  const auto [x, y, z, w] = message.orientation;
  const Eigen::Quaterniond orientation = Eigen::Quaterniond(w, x, y, z).normalized();
  const Eigen::Vector3d velocity(message.velocity.data());
  State state;
  state.stamp_ns = stamp_ns;
  state.position = Eigen::Vector3d(message.position.data());
  state.heading = ros_messages::headingOf(message.orientation);
  state.velocity = {orientation * velocity, velocity};
  state.turn_rate = message.angular_velocity[2];
  const double seconds = 1e-9 * static_cast<double>(stamp_ns - last_.stamp_ns);
  if (!begun_ || stamp_ns - last_.stamp_ns > kInterval_ns) {  // nothing is known of such a hole
    begin(state);
  } else {
    for (std::size_t k = 0; k < kFrames; ++k) moved_[k] += seconds * last_.velocity[k];
    turned_ += seconds * last_.turn_rate;
  }
  begun_ = true;
  last_ = state;
  if (stamp_ns - start_.stamp_ns >= kInterval_ns) endInterval(state);
}

void OdometrySpeeds::endInterval(const State& state) {
  const Eigen::Vector3d step = state.position - start_.position;
  seconds_ += 1e-9 * static_cast<double>(state.stamp_ns - start_.stamp_ns);
  by_poses_ += step.norm();
  for (std::size_t k = 0; k < kFrames; ++k) {
    by_velocities_[k] += moved_[k].norm();
    products_[k] += moved_[k].norm() * step.norm();
    scalar_products_[k] += moved_[k].dot(step);
  }
  const double turn = wrapAngle(state.heading - start_.heading);
  turns_by_poses_ += std::abs(turn);
  turns_by_rates_ += std::abs(turned_);
  turn_squares_ += turned_ * turned_;
  turn_products_ += turn * turned_;
  begin(state);
}

std::string OdometrySpeeds::doubtOfLengths(double by_velocities) const {
  const double smaller = std::min(by_poses_, by_velocities);
  if (std::max(by_poses_, by_velocities) < kFactor * smaller) return "";
  return "its poses make a path of " + shortNumber(by_poses_) + " m, and its velocities one of " +
         shortNumber(by_velocities) + " m: are both in m and m/s?";
}

std::string OdometrySpeeds::doubtOfTurns() const {
  const bool turns = turns_by_rates_ >= std::max(kLeastTurn, kSlowTurn * seconds_);
  if (!turns || turn_products_ >= kAgreement * turn_squares_) return "";
  return "its poses turn by " + degrees(turns_by_poses_) + ", " +
         (turn_products_ < 0 ? "mostly the other way than" : "and") +
         " its angular velocities by " + degrees(turns_by_rates_) +
         ": are the orientations right (x y z w, z upwards)?";
}

std::string OdometrySpeeds::doubt() const {
  const std::size_t frame = scalar_products_[1] > scalar_products_[0] ? 1 : 0;
  const double by_velocities = by_velocities_[frame];
  const bool moves = std::max(by_poses_, by_velocities) >= kSlow * seconds_;
  if (seconds_ == 0 || by_velocities == 0 || by_poses_ == 0) return doubtOfTurns();
  if (!moves) return doubtOfTurns();
  if (const std::string lengths = doubtOfLengths(by_velocities); !lengths.empty()) return lengths;
  if (scalar_products_[frame] >= kAgreement * products_[frame]) return doubtOfTurns();
  return "its poses move in other directions than its velocities: are the orientations right (x y "
         "z w, z upwards), and the velocities those of the robot (x forward)?";
}

}  // namespace tolman::ros_bag
