// SPDX-License-Identifier: BSD-3-Clause
// The landmarks of all templates, and the question whether a view shows those of one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "landmark_pose.hpp"
#include "tolman/records.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_templates {

/// For stereo pairs; without a right image a template has no landmarks.
class LandmarkMemory {
 public:
  LandmarkMemory(const CameraRig& rig, int corners, int least_agreeing)
      : rig_(rig), corners_(corners), least_(least_agreeing) {}

  /// Whether the cameras can measure any.
  bool hasStereo() const { return rig_.isStereo() && rig_.calibrated; }
  /// A new frame comes: what was seen in the last one no longer counts.
  void beginFrame() { looked_ = false; }
  /// Landmarks of the next template.
  void add(const Frame& frame);
  std::size_t size() const { return templates_.size(); }
  /// Whether template `id` has enough of them to be recognised.
  bool knows(std::int64_t id) const;
  /// Where the camera is, seen from where template `id` was made; none: the view shows another
  /// place.
  std::optional<MeasuredPose> locate(const Frame& frame, std::int64_t id);

  void save(StateWriter& writer) const;
  /// False when the state is damaged.
  bool load(StateReader& reader);

 private:
  const Corners& cornersOf(const Frame& frame);

  CameraRig rig_;
  int corners_;
  int least_;
  std::vector<Landmarks> templates_;
  Corners seen_;         ///< in the present frame
  bool looked_ = false;  ///< whether seen_ is up to date
};

}  // namespace tolman::view_templates
