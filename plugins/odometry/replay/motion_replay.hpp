// SPDX-License-Identifier: BSD-3-Clause
// Odometry `motion_replay`: the planar motion that the source recorded (sensor motion.planar: x, y
// in m, theta in rad), or the motion of a recorded run, with optional noise, bias and losses.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "recorded_answers.hpp"
#include "tolman/roles.hpp"

namespace tolman::motion_replay {

struct MotionReplayParameters {
  std::string record;
  double sigma_distance = 0.02;  // chosen, not tuned
  double sigma_heading = 0.002;  // rad/m^0.5; chosen, not tuned
  double noise_distance = 0;
  double noise_heading = 0;
  double bias_distance = 0;
  double bias_heading = 0;
  double bias_height = 0;
  double lost = 0;
  std::int64_t carried_at = -1;

  static constexpr auto declaration() {
    using P = MotionReplayParameters;
    return parameters(
        parameter("record", &P::record)
            .path()
            .doc("Run directory, of a run with `record.replay: true`, whose motions are replayed "
                 "with their own covariances; empty: those of the source."),
        parameter("sigma_distance", &P::sigma_distance)
            .range(1e-6, 10)
            .doc("Reported standard deviation of a step's length, relative to it."),
        parameter("sigma_heading", &P::sigma_heading)
            .range(1e-7, 3)
            .unit("rad/m^0.5")
            .doc("Reported standard deviation of heading, growing with the root of distance."),
        parameter("noise_distance", &P::noise_distance)
            .range(0, 10)
            .doc("Noise added to a step's length, standard deviation relative to it."),
        parameter("noise_heading", &P::noise_heading)
            .range(0, 3)
            .unit("rad/m^0.5")
            .doc("Noise added to the turn, standard deviation, growing with the root of distance."),
        parameter("bias_distance", &P::bias_distance)
            .range(-0.9, 10)
            .doc("Lengths are multiplied by 1 + this."),
        parameter("bias_heading", &P::bias_heading)
            .range(-1, 1)
            .unit("rad/m")
            .doc("Turn that is added per metre driven."),
        parameter("bias_height", &P::bias_height)
            .range(-1, 1)
            .unit("m/m")
            .doc("Height that is lost per metre driven, along the camera's vertical axis."),
        parameter("lost", &P::lost)
            .range(0, 1)
            .doc("Share of frames whose motion is not measured but predicted from the frame "
                 "before."),
        parameter("carried_at", &P::carried_at)
            .range(-1, 1e9)
            .unit("frame")
            .doc("Frame at which tracking restarts at an unknown pose; -1: never."));
  }
};

class MotionReplay final : public Odometry {
 public:
  using Parameters = MotionReplayParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status track(const Frame& frame, Motion& motion) override;
  Status finish(std::vector<MotionRevision>& revisions) override;

 private:
  /// Noise and bias of one motion: a factor of its length, a turn (rad) about the camera's vertical
  /// axis, and a translation along this axis (m, downwards).
  struct Disturbance {
    double stretch = 1;
    double turn = 0;
    double sink = 0;
  };
  static const std::vector<float>* sensor(const Frame& frame, std::string_view name);
  bool carried(const Frame& frame) const;
  static bool isNotZero(const Frame& frame, std::string_view name);
  Disturbance draw(double distance);
  Status replay(const Frame& frame, Motion& motion);
  void disturb(std::int64_t frame, Eigen::Isometry3d& T_previous_current) const;

  Parameters parameters_;
  std::uint64_t seed_ = 0;
  RandomStream random_{0};
  PlanarPose last_step_;
  std::int64_t last_stamp_ns_ = 0;
  recorded_answers::RecordedAnswers reader_;  ///< of `record`
  std::vector<Disturbance> disturbances_;     ///< of the replayed frames; empty without any
};

}  // namespace tolman::motion_replay
