// SPDX-License-Identifier: BSD-3-Clause
// What the roles promise of their answers beside frame, stamp and values (values.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Symmetric and positive semidefinite, up to rounding; zero is allowed. `field`: its name.
Status checkCovariance(const Matrix6d& covariance, const char* field);

/// Revisions of frames `oldest` to `newest`.
Status checkRevisions(const std::vector<MotionRevision>& revisions, std::int64_t oldest,
                      std::int64_t newest);

/// `is_first`: the first motion of a session.
Status checkMotion(const Motion& motion, bool is_first);

/// Checks that a template id is dense or known. `templates`: number so far, -1 if not known.
Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates);

/// Its covariance, where it has a relative pose.
Status checkPlace(const PlaceObservation& observation);

/// `experiences`: number before this decision. `last`: the experience of the decision before; below
/// -1: not known.
Status checkDecision(const Decision& decision, std::int64_t experiences, std::int64_t last);

/// `last_version`: of the update before.
Status checkUpdate(const MapUpdate& update, std::int64_t last_version);

/// What the answers of a map have told so far.
struct KnownMap {
  std::int64_t newest_frame = INT64_MAX;  ///< that the map has answered; the largest: not known
  std::int64_t version = INT64_MIN;       ///< of the last update; the smallest: not known
  std::int64_t experiences = -1;          ///< at the last update; -1: not known
};

/// Ids, frames and values of experiences and links, and that it is the map of the last update.
Status checkGraph(const MapGraph& graph, const KnownMap& known);

}  // namespace tolman::host
