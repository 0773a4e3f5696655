// SPDX-License-Identifier: BSD-3-Clause
// Checks the answers of the roles against the contract of the SDK. Frame, stamp and values are
// checked elsewhere (stages.hpp, values.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Requires a symmetric, positive semidefinite matrix, up to rounding; zero is allowed. `field`:
/// its name.
Status checkCovariance(const Matrix6d& covariance, const char* field);

/// Requires that only frames `oldest` to `newest` are revised.
Status checkRevisions(const std::vector<MotionRevision>& revisions, std::int64_t oldest,
                      std::int64_t newest);

/// `is_first`: the first motion of a session.
Status checkMotion(const Motion& motion, bool is_first);

/// Requires the next template id for a novel view, and an existing one for a familiar view.
/// `templates`: number so far, -1 if not known.
Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates);

/// Checks the covariance of an observation with a relative pose.
Status checkPlace(const PlaceObservation& observation);

/// `experiences`: number before this decision. `last`: the experience of the decision before; below
/// -1: not known. `templates`: ids below it were given by place recognition.
Status checkDecision(const Decision& decision, std::int64_t experiences, std::int64_t last,
                     std::int64_t templates = INT64_MAX);

/// `last_version`: version of the previous update.
Status checkUpdate(const MapUpdate& update, std::int64_t last_version);

/// What is known of a map from its answers so far.
struct KnownMap {
  std::int64_t newest_frame = INT64_MAX;  ///< newest answered frame; INT64_MAX: not known
  std::int64_t version = INT64_MIN;       ///< of the last update; INT64_MIN: not known
  std::int64_t experiences = -1;          ///< at the last update; -1: not known
  std::int64_t links = -1;                ///< the same; includes rejected links
  std::int64_t loops = -1;                ///< the same
  std::int64_t templates = INT64_MAX;     ///< that decisions named; INT64_MAX: not known
};

/// Checks ids, frames and values of experiences and links, and that they agree with `known`.
Status checkGraph(const MapGraph& graph, const KnownMap& known);

/// Requires that the pose of an update is that of its experience in the graph, composed with
/// T_experience_camera. `graph` must belong to the update.
Status checkPlaced(const MapUpdate& update, const MapGraph& graph);

/// Requires that poseOf() and another answer give a frame the same pose. `what` names the other
/// answer: "the update".
Status checkSamePose(const Eigen::Isometry3d& T_world_camera, const Eigen::Isometry3d& other,
                     const std::string& what);

}  // namespace tolman::host
