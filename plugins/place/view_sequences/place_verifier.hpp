// SPDX-License-Identifier: BSD-3-Clause
// Verifies places by landmarks: the corners with depth of a stored view must agree on a pose of the
// present view, otherwise it is another place.
#pragma once

#include <cstdint>
#include <optional>

#include "landmark_pose.hpp"
#include "landmark_store.hpp"
#include "tolman/records.hpp"

namespace tolman::view_sequences {

struct VerifierSettings {
  int corners = 0;           ///< most corners that a view keeps; 0: no landmarks
  int least_agreeing = 20;   ///< landmarks
  std::int64_t spacing = 4;  ///< views from one that keeps landmarks to the next
};

class PlaceVerifier {
 public:
  PlaceVerifier(const CameraRig& rig, const VerifierSettings& settings)
      : rig_(rig), settings_(settings) {}

  /// Whether landmarks are enabled and the rig is a calibrated stereo pair.
  bool canMeasure() const { return settings_.corners > 0 && rig_.isStereo() && rig_.calibrated; }
  /// Sets the frame of the following calls. It must exist until the next call.
  void beginFrame(const Frame& frame);
  /// The frame was stored as `view`: keeps its landmarks, if they are due.
  Status store(std::int64_t view);
  /// A view with landmarks at `view` or next to it.
  std::optional<std::int64_t> viewNear(std::int64_t view) const;
  /// Pose of the frame relative to a view with landmarks; empty if too few agree.
  Result<std::optional<landmarks::MeasuredPose>> locate(std::int64_t view);
  /// The same by the edges around landmarks. They are also found under other illumination, but only
  /// from nearly the same direction.
  Result<std::optional<landmarks::MeasuredPose>> locateByEdges(std::int64_t view);

  Status save(StateWriter& writer) const { return store_.save(writer); }
  Status load(StateReader& reader, std::int64_t views) { return store_.load(reader, views); }

 private:
  const landmarks::Corners& corners();
  const landmarks::EdgeMap& edges();
  std::optional<landmarks::MeasuredPose> poseByEdges(const StoredLandmarks& stored,
                                                     std::size_t step, int least, double share);

  CameraRig rig_;
  VerifierSettings settings_;
  LandmarkStore store_;
  const Frame* frame_ = nullptr;
  std::optional<landmarks::Corners> corners_;         ///< of the frame, computed when needed
  landmarks::EdgeMap edges_;                          ///< as corners_
  bool has_edges_ = false;                            ///< whether edges_ are of the frame
  std::optional<landmarks::EdgeSearch> edge_search_;  ///< as corners_
};

}  // namespace tolman::view_sequences
