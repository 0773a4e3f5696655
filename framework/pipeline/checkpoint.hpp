// SPDX-License-Identifier: BSD-3-Clause
// The chain between two frames.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "pipeline/run_counters.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::pipeline {

/// What a later process needs to process the frames after `frame` as this one would have, in
/// addition to the answers to that frame and to an odometry that has seen the same frames.
struct Checkpoint {
  std::int64_t frame = -1;             ///< the last one that it contains
  RunCounters counters;                ///< of the frames up to it
  std::map<Role, std::string> states;  ///< of place, cells and map
};

/// A checkpoint, and the answers to its frame.
struct ResumePoint {
  Checkpoint checkpoint;
  Motion motion;
  Decision decision;
  MapUpdate map;
};

}  // namespace tolman::pipeline
