// SPDX-License-Identifier: BSD-3-Clause
// Everything in the plugin that changes from frame to frame.
#pragma once

#include <experience_log.hpp>
#include <iosfwd>
#include <map>
#include <optional>
#include <vector>

#include "bump_network.hpp"
#include "level_step.hpp"
#include "tolman/status.hpp"
#include "waiting_loops.hpp"

namespace tolman::bayesian_attractor {

/// What one view template was linked to: when it was made, or when it was seen on another storey.
struct ViewLink {
  LearnedPattern learned;
  double travel = 0;            ///< m driven until it was learned
  std::int64_t experience = 0;  ///< the experience that the robot was at
  /// Pose of the template in the coordinates of that experience, by path integration.
  Eigen::Isometry3d T_experience_template = Eigen::Isometry3d::Identity();
};

/// While the robot localises itself: where it is, since a view last said so.
struct KnownPlace {
  double travel = 0;                       ///< m driven until that view
  Matrix6d covariance = Matrix6d::Zero();  ///< of the present pose, relative to the experience
};

struct AttractorState {
  BumpNetwork network;
  ExperienceLog log;
  WaitingLoops waiting;
  /// By template id: one link for each storey, in the order of learning.
  std::map<std::int64_t, std::vector<ViewLink>> links = {};
  Upright upright = {};
  bool initialising = true;              ///< the last motion was in state Initialising
  std::optional<KnownPlace> known = {};  ///< only while the robot localises itself; not saved
};

// The state of the cells, written to and read from a stream.

Status saveState(const AttractorState& state, std::ostream& stream);

/// Overwrites `state`, which must be fresh; it is not to be used after a failure.
Status loadState(std::istream& stream, AttractorState& state);

}  // namespace tolman::bayesian_attractor
