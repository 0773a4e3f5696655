// SPDX-License-Identifier: BSD-3-Clause
// The state of the stages between two frames.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "engine/run_counters.hpp"
#include "engine/scale_check.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::pipeline {

/// State with which a later process continues after `frame` as this one would have. It also needs
/// the answers to that frame, and an odometry that has processed the same frames.
struct Checkpoint {
  std::int64_t frame = -1;             ///< the last processed frame
  RunCounters counters;                ///< of all frames up to it
  std::map<Role, std::string> states;  ///< of place, cells and map
};

/// A checkpoint, and the answers to its frame.
struct ResumePoint {
  Checkpoint checkpoint;
  Motion motion;
  Decision decision;
  MapUpdate map;
  std::optional<MapScale> scale{};  ///< none: no motion was tracked so far
};

}  // namespace tolman::pipeline
