// SPDX-License-Identifier: BSD-3-Clause
// Stores the landmarks of all templates and measures the pose of a frame relative to a template.
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

  /// Whether the rig can measure landmarks.
  bool hasStereo() const { return rig_.isStereo() && rig_.calibrated; }
  /// Invalidates the corners of the previous frame.
  void beginFrame() { has_corners_ = false; }
  /// Stores the landmarks of the next template.
  void add(const Frame& frame);
  std::size_t size() const { return templates_.size(); }
  /// Whether template `id` has enough landmarks to be recognised by them.
  bool hasEnough(std::int64_t id) const;
  /// Pose of the camera relative to template `id`; empty if too few landmarks agree.
  std::optional<landmarks::MeasuredPose> locate(const Frame& frame, std::int64_t id);

  void save(StateWriter& writer) const;
  /// False when the state is damaged.
  bool load(StateReader& reader);

 private:
  const landmarks::Corners& cornersOf(const Frame& frame);

  CameraRig rig_;
  int corners_;
  int least_;
  std::vector<landmarks::Landmarks> templates_;
  landmarks::Corners frame_corners_;  ///< of the current frame
  bool has_corners_ = false;          ///< whether frame_corners_ is up to date
};

}  // namespace tolman::view_templates
