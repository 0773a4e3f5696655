// SPDX-License-Identifier: BSD-3-Clause
// Receives the frames and events of a run. The engine implements it with recorder and observers
// (run/run_listener.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/frame_records.hpp"
#include "tolman/context.hpp"

namespace tolman::pipeline {

using Event = RunEvent;

/// The pose that the final map gives a frame.
struct FramePose {
  std::int64_t frame = -1;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// Frames come in order, one call at a time, not always from the same thread; events may come from
/// any thread at any time.
class Listener {
 public:
  virtual ~Listener() = default;
  /// A failure stops the run. The snapshot comes without events.
  virtual Status onFrame(const Snapshot& snapshot) = 0;
  virtual void onEvent(const Event& event) = 0;
  /// Whether the stages shall save their state after the next frame, for onCheckpoint(). Called
  /// once for each frame before it enters the stages.
  virtual bool checkpointDue() { return false; }
  /// A failure stops the run.
  virtual Status onCheckpoint(const Checkpoint& /*checkpoint*/) { return Status::ok(); }
  /// After the last frame and before onFinish(): final poses of all frames, those of earlier
  /// sessions included.
  virtual Status onTrajectory(const std::vector<FramePose>& /*poses*/) { return Status::ok(); }
  /// After the last frame, with the final map.
  virtual Status onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) = 0;
};

}  // namespace tolman::pipeline
