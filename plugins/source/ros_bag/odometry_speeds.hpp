// SPDX-License-Identifier: BSD-3-Clause
// Whether the poses of odometry messages agree with the velocities in the same messages.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>

#include "messages.hpp"

namespace tolman::ros_bag {

/// Compares motions by poses and by velocities over intervals of a second, so that their noise does
/// not make a path of a robot that stands.
class OdometrySpeeds {
 public:
  /// Messages by time.
  void add(std::int64_t stamp_ns, const ros_messages::OdometryMessage& message);
  /// Without the topic; empty if they agree, or if there are no velocities or no motion.
  std::string doubt() const;

 private:
  /// Velocities in the frame of the robot, as ROS prescribes, and in that of the poses, as some
  /// simulators write them.
  static constexpr std::size_t kFrames = 2;
  struct State {
    std::int64_t stamp_ns = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double heading = 0;
    std::array<Eigen::Vector3d, kFrames> velocity{};
    double turn_rate = 0;
  };
  void begin(const State& state);
  void endInterval(const State& state);
  std::string doubtOfLengths(double by_velocities) const;
  std::string doubtOfTurns() const;

  bool begun_ = false;
  State last_;
  State start_;                                    ///< of the interval
  std::array<Eigen::Vector3d, kFrames> moved_{};   ///< by the velocities since then, m
  double turned_ = 0;                              ///< rad
  double seconds_ = 0;                             ///< of all intervals
  double by_poses_ = 0;                            ///< m
  std::array<double, kFrames> by_velocities_{};    ///< m
  std::array<double, kFrames> products_{};         ///< of lengths, m^2
  std::array<double, kFrames> scalar_products_{};  ///< of motions, m^2
  double turns_by_poses_ = 0;                      ///< rad, absolute
  double turns_by_rates_ = 0;                      ///< rad, absolute
  double turn_squares_ = 0;                        ///< of turns by rates, rad^2
  double turn_products_ = 0;                       ///< rad^2
};

}  // namespace tolman::ros_bag
