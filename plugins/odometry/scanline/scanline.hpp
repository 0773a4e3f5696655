// SPDX-License-Identifier: BSD-3-Clause
// Scanline odometry (Milford and Wyeth 2008; Ball et al. 2013): planar motion from the shift and
// the difference of two consecutive intensity profiles. Turns in rad, distances in arbitrary units.
#pragma once

#include <optional>
#include <vector>

#include "parameters.hpp"
#include "profile.hpp"
#include "tolman/roles.hpp"

namespace tolman::scanline {

class Scanline final : public Odometry {
 public:
  using Parameters = scanline::Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status track(const Frame& frame, Motion& motion) override;
  Status finish(std::vector<MotionRevision>& revisions) override;

 private:
  /// The two profiles of one image.
  struct Scan {
    Profile turn;
    Profile speed;
  };

  std::optional<Scan> scan(const Image& image) const;
  void answerMeasured(const Scan& now, Motion& motion);
  void answerPredicted(Motion& motion);

  Parameters parameters_;
  CameraRig rig_;
  std::optional<ProfileMaker> turn_maker_;
  std::optional<ProfileMaker> speed_maker_;

  // State that reset() clears.
  std::optional<Scan> reference_;  ///< of the last frame with contrast
  double v_ = 0;                   ///< m/s, as last measured
  double omega_ = 0;               ///< rad/s
  PlanarPose predicted_;           ///< motion since the reference, while lost
  double since_reference_ = 0;     ///< s
  int lost_frames_ = 0;
  std::int64_t last_stamp_ns_ = -1;  ///< -1 before the first frame
};

}  // namespace tolman::scanline
