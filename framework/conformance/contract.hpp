// SPDX-License-Identifier: BSD-3-Clause
// What roles.hpp and records.hpp promise of answers, beyond what the host checks at every frame.
#pragma once

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// Rotations are rotations, covariances symmetric without negative variances, dt is the time since
/// the frame before (none before the first), the first frame has no motion.
Status checkMotion(const Motion& motion, const Frame& frame, const Frame* previous);

Status checkRevisions(const std::vector<MotionRevision>& revisions);

/// Template ids are dense; -1 exactly with None. `templates` counts those made so far.
Status checkPlace(const PlaceObservation& seen, std::int64_t& templates);

/// Stay stays; the relative pose is a pose. `last` is the experience of the last decision.
Status checkDecision(const Decision& decision, std::int64_t last);

/// Counts agree with the graph, the version never falls.
Status checkUpdate(const MapUpdate& update, const MapGraph& graph, std::int64_t last_version);

/// Whether two poses are equal up to rounding.
bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

}  // namespace tolman::conformance
