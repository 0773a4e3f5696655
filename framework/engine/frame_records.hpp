// SPDX-License-Identifier: BSD-3-Clause
// A frame on its way through the stages, with the answers that they have given so far, and who
// receives it at the end.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/checked_odometry.hpp"
#include "engine/run_counters.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// State with which a later process continues after `frame` as this one would have. It also needs
/// the answers to that frame, and an odometry that has processed the same frames.
struct Checkpoint {
  std::int64_t frame = -1;             ///< the last processed frame
  RunCounters counters;                ///< of all frames up to it
  std::map<Role, std::string> states;  ///< of place, cells and map
};

/// The unit of the lengths of a map, as its last tracked motion gave them.
struct MapScale {
  bool is_known = true;  ///< metres
  std::string session;   ///< the earlier run that gave them; empty: the session itself
};

/// A checkpoint, and the answers to its frame.
struct ResumePoint {
  Checkpoint checkpoint;
  Motion motion;
  Decision decision;
  MapUpdate map;
  std::optional<MapScale> scale{};  ///< none: no motion was tracked so far
};

struct FrameRecords {
  Frame frame;
  Motion motion;
  PlaceObservation place;
  Decision decision;
  MapUpdate map;
  std::vector<NamedArray> cells;
  MapGraph graph;
  std::size_t sequence = 0;      ///< consecutive number in the order of dispatch
  bool graph_changed = false;    ///< `graph` is published with this frame
  bool leave_out_place = false;  ///< realtime: place recognition is late and skips this frame
  bool answered = false;         ///< all stages have answered; the listener may get it
  Status odometry_status;
  Impossible impossible;
  Status place_status;
  StageTimes times{};
  std::chrono::nanoseconds exposed{};  ///< realtime: on the clock of PacedFeed; likewise the next
  std::chrono::steady_clock::time_point posed;  ///< when the map had answered
  std::unique_ptr<Checkpoint> checkpoint;       ///< null: no checkpoint after this frame

  Snapshot snapshot() const {
    return {&frame, &motion, &place, &decision, &map, &cells, graph_changed ? &graph : nullptr,
            times};
  }
};
using FrameRecordsPtr = std::shared_ptr<FrameRecords>;

using Event = RunEvent;

/// The pose that the final map gives a frame.
struct FramePose {
  std::int64_t frame = -1;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// Receives the frames and events of a run: the recorder and the observers (run_listener.hpp).
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

}  // namespace tolman::engine
