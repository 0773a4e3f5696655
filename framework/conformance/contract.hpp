// SPDX-License-Identifier: BSD-3-Clause
// Requirements of roles.hpp and records.hpp on answers that the host does not check at every frame.
#pragma once

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// Rotations are orthonormal, covariances symmetric with non-negative variances, dt is the time
/// since the previous frame (0 for the first), the motion of frame 0 is the identity.
Status checkMotion(const Motion& motion, const Frame& frame, const Frame* previous);

Status checkRevisions(const std::vector<MotionRevision>& revisions);

/// Template ids are dense; -1 exactly with None. `templates` counts those made so far.
Status checkPlace(const PlaceObservation& seen, std::int64_t& templates);

/// Stay keeps the experience of the last decision, `last`; a relative pose is a valid pose.
Status checkDecision(const Decision& decision, std::int64_t last);

/// Counts agree with the graph, the version never decreases.
Status checkUpdate(const MapUpdate& update, const MapGraph& graph, std::int64_t last_version);

/// Whether two poses are equal up to rounding.
bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

}  // namespace tolman::conformance
