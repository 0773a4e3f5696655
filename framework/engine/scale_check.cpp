// SPDX-License-Identifier: BSD-3-Clause
#include "engine/scale_check.hpp"

#include <fmt/format.h>

#include <utility>

namespace tolman::pipeline {
namespace {

const char* unitText(bool is_known) {
  return is_known ? "metres (scale_known is true)" : "arbitrary units (scale_known is false)";
}

}  // namespace

std::optional<ScaleCheck::Change> ScaleCheck::check(const Motion& motion) {
  if (motion.state != TrackingState::Tracking) return std::nullopt;
  const std::optional<MapScale> before =
      std::exchange(scale_, MapScale{motion.scale_known, std::string()});
  if (!before || before->is_known == motion.scale_known) return std::nullopt;
  if (before->session.empty()) {
    return Change{fmt::format("the lengths of this motion are in {}, those before in {}; the map "
                              "joins both as if they were of one unit, so its lengths and errors "
                              "mean nothing: answer `initialising` until the scale is known",
                              unitText(motion.scale_known), unitText(before->is_known)),
                  false};
  }
  return Change{fmt::format("frame {}: odometry gives lengths in {}, and the map of the earlier "
                            "session {} has lengths in {}; continue it with an odometry of the "
                            "same kind, or begin a new map without --continue",
                            motion.frame, unitText(motion.scale_known), before->session,
                            unitText(before->is_known)),
                true};
}

}  // namespace tolman::pipeline
