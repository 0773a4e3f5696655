// SPDX-License-Identifier: BSD-3-Clause
// Counts of a run, and what they say where it found no motion.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// Counters of the health of a run.
struct RunCounters {
  std::int64_t frames = 0;      ///< processed
  std::int64_t dropped = 0;     ///< realtime: never processed
  std::int64_t skipped = 0;     ///< frames at which a stage failed and the run continued
  std::int64_t impossible = 0;  ///< motions that `checks` replaced by a prediction, and frames with
                                ///< a revision that they left out
  std::int64_t defects = 0;     ///< frames whose images are missing or faulty (Frame::defect)
  std::int64_t initialising = 0;    ///< frames before odometry gave a motion; at least the first
  std::int64_t lost = 0;            ///< frames with odometry lost
  std::int64_t nearly_black = 0;    ///< frames without tracking, see isNearlyBlack()
  std::int64_t unmoved = 0;         ///< tracked frames whose motion is exactly zero
  std::int64_t place_left_out = 0;  ///< realtime: frames without place recognition
  std::int64_t templates = 0;       ///< with those of earlier sessions
  std::int64_t experiences = 0;     ///< of the newest published graph, at the end the final one
  std::int64_t loop_decisions = 0;  ///< Action::CloseLoop, also those that the map rejects later
  std::int64_t links = 0;           ///< of the same graph as experiences, without rejected ones
  std::int64_t loop_links = 0;      ///< those of kind LinkKind::Loop
  bool lost_at_end = false;

  /// Calls visit(name, value) for each count.
  template <class Self, class Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("frames", self.frames);
    visit("dropped", self.dropped);
    visit("skipped", self.skipped);
    visit("impossible", self.impossible);
    visit("defects", self.defects);
    visit("initialising", self.initialising);
    visit("lost", self.lost);
    visit("nearly_black", self.nearly_black);
    visit("unmoved", self.unmoved);
    visit("place_left_out", self.place_left_out);
    visit("templates", self.templates);
    visit("experiences", self.experiences);
    visit("loop_decisions", self.loop_decisions);
    visit("links", self.links);
    visit("loop_links", self.loop_links);
    visit("lost_at_end", self.lost_at_end);
  }

  std::int64_t tracked() const { return frames - initialising - lost; }
  /// Whether no motion was found in the whole run.
  bool neverTracked() const { return frames > 0 && tracked() == unmoved; }
  /// The warning for a run that never tracked, or was lost at its end, by the likely cause; empty
  /// if there is none.
  std::string_view endText() const;
};

// A frame on its way through the stages, with the answers that they have given so far, and who
// receives it at the end.

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
  std::vector<std::string> impossible;  ///< what CheckedOdometry replaced or left out
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
  /// Name of the stage that a failure of these functions is of.
  virtual std::string failedStage() const { return std::string(enumName(Role::Observer)); }
  /// After the last frame, with the final map.
  virtual Status onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) = 0;
};

}  // namespace tolman::engine
