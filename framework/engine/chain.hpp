// SPDX-License-Identifier: BSD-3-Clause
// The stages of a run in the order of the flow: the counts of a run, a frame on its way, and the
// chain that calls the stages for it.
#pragma once

#include <oneapi/tbb/task_arena.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/record_rows.hpp"
#include "config/settings.hpp"
#include "engine/checked_odometry.hpp"
#include "engine/failure.hpp"
#include "engine/localised_map.hpp"
#include "engine/rectified_source.hpp"
#include "host/guard.hpp"
#include "host/stages.hpp"
#include "tolman/context.hpp"
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
  std::size_t sequence = 0;    ///< consecutive number in the order of dispatch
  bool graph_changed = false;  ///< `graph` is published with this frame
  bool answered = false;       ///< all stages have answered; the listener may get it
  Status odometry_status;
  std::vector<std::string> impossible;  ///< what CheckedOdometry replaced or left out
  Status place_status;
  StageTimes times{};
  std::chrono::steady_clock::time_point exposed;  ///< realtime, by the pace of the stamps
  std::chrono::steady_clock::time_point posed;    ///< when the map had answered
  std::unique_ptr<Checkpoint> checkpoint;         ///< null: no checkpoint after this frame

  Snapshot snapshot() const {
    return {&frame, &motion, &place, &decision, &map, &cells, graph_changed ? &graph : nullptr,
            times};
  }
};
using FrameRecordsPtr = std::shared_ptr<FrameRecords>;

using Event = RunEvent;

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
  virtual Status onTrajectory(const std::vector<record::FinalPose>& /*poses*/) {
    return Status::ok();
  }
  /// Name of the stage that a failure of these functions is of.
  virtual std::string failedStage() const { return std::string(enumName(Role::Observer)); }
  /// After the last frame, with the final map.
  virtual Status onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) = 0;
};

// The stages of a run in the order of the flow, and what happens when one of them fails.

/// Calls `call` and returns its result. While `call` waits for its own parallel loops, its thread
/// takes no tasks of other stages: decoding an image in the meantime would delay the answer and all
/// stages that wait for it.
template <class Call>
auto withoutOtherTasks(Call&& call) {
  return tbb::this_task_arena::isolate(call);
}

/// `on_failure` of the stages by role; that of observers is applied by the listener.
using Policies = std::array<config::FailurePolicy, kRoleNames.size()>;

struct Stages {
  RectifiedSource& source;
  CheckedOdometry& odometry;
  host::PlaceStage& place;
  host::CellsStage& cells;
  host::MapStage& map;
};

/// Calls the stages for each frame and counts their answers. odometry() and place() may run at the
/// same time, also for different frames; each function must be called for one frame at a time, in
/// the order of frames.
class Chain {
 public:
  /// The stages must be configured already.
  Chain(const Stages& stages, const Policies& policies, Listener& listener)
      : stages_(stages),
        policies_(policies),
        listener_(listener),
        place_needs_motion_(stages.place.input() == PlaceInput::FrameAndMotion),
        can_save_(stages.place.instance().state() && stages.cells.instance().state() &&
                  stages.map.instance().state()) {}

  void odometry(FrameRecords& records);
  void place(FrameRecords& records);
  /// After a failure, later frames are not processed and get no answers.
  void runCellsAndMap(FrameRecords& records);
  /// Passes the answers to the listener. Frames that the map processed before a failure are passed
  /// on as well, even if the listener itself has failed.
  void publish(FrameRecords& records);
  /// Finishes odometry, place, cells and map, then passes the final trajectory and graph to the
  /// listener.
  void finish();

  /// Passes the state after the last processed frame to the listener. Does nothing after a failure,
  /// or if place, cells and map cannot all save their state. No stage may be working on a frame.
  void saveNow();
  /// Continues after a checkpoint; call it before the first frame is admitted. The stages must have
  /// the state of the checkpoint.
  void resume(const ResumePoint& point);
  /// The map of an earlier session is continued; call it before the first frame is admitted.
  void continueMap(MapScale scale) { scale_ = std::move(scale); }
  /// The robot is found in this map, which stays as it is; likewise. The map's stage is asked only
  /// for its poses and graph, and no state is saved.
  void localise(LocalisedMap map) {
    localised_ = std::move(map);
    can_save_ = false;
  }

  /// Whether a stage or the listener failed; no later frame is answered.
  bool failed() const;
  void fail(Role role, const Status& status);
  /// Calls `work` of a node of the flow. Its exception, such as of memory that is short, is a
  /// failure of `role`, so that the frames in the flow still reach its end.
  template <class Work>
  void guarded(Role role, Work&& work) {
    const Status status = host::contained([&] {
      work();
      return Status::ok();
    });
    if (!status.isOk()) failBy(role, status);
  }
  /// The failure that stopped the run: of a stage or of the listener, else of the source; none if
  /// there is none.
  std::optional<Failure> failure() const;
  /// Whether place recognition must run after odometry.
  bool placeNeedsMotion() const { return place_needs_motion_; }
  /// Numbers and checks a frame that enters the stages; one call at a time.
  void admit(FrameRecords& records);
  /// Time that finish() of each stage took.
  const StageTimes& finishTimes() const { return finish_times_ns_; }
  /// The next frame of the source; null at its end, after a failure, or when cancelled. Frames that
  /// a source gave before it failed are still processed.
  FrameRecordsPtr readFrame(const Cancellation& cancellation);
  const RunCounters& counters() const { return counters_; }
  RunCounters& counters() { return counters_; }
  Stages& stages() { return stages_; }
  Listener& listener() { return listener_; }

 private:
  void failBy(Role role, const Status& status);
  /// The name of the stage in the configuration.
  std::string nameOf(Role role) const;
  /// Whether the run continues after an answer with this status (`on_failure` of the stage).
  bool applyPolicy(const Status& status, std::int64_t frame, Role role);
  bool stopsFor(Role role) const {
    return policies_[static_cast<std::size_t>(role)] == config::FailurePolicy::Stop;
  }
  void warn(std::int64_t frame, Role role, const std::string& text);
  bool acceptMotion(FrameRecords& records);
  bool acceptScale(const Motion& motion);
  void reportImpossible(std::int64_t frame, const std::vector<std::string>& texts);
  bool acceptObservation(FrameRecords& records);
  bool runCells(FrameRecords& records);
  bool runMap(FrameRecords& records);
  void publishGraph(FrameRecords& records);
  void count(const FrameRecords& records);
  void countGraph(const MapGraph& graph);
  std::vector<MotionRevision> finishStages();
  /// Calls `work` of finish(), adds its time, and applies the policy of the role. False on failure.
  template <class Work>
  bool finishing(Role role, const Work& work) {
    const Status status = timed(finish_times_ns_, role, work);
    (void)applyPolicy(status, -1, role);
    return status.isOk();
  }
  void completeCounters();
  Status readTrajectory(std::vector<record::FinalPose>& poses) const;
  Status finalGraph(const std::vector<record::FinalPose>& poses, MapGraph& graph);
  /// Calls `work`, and adds its time to `times`.
  template <class Work>
  static Status timed(StageTimes& times, Role role, const Work& work) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    Status status = work();
    times[static_cast<std::size_t>(role)] += (Clock::now() - begin) / std::chrono::nanoseconds(1);
    return status;
  }
  void save(Role role, host::Instance& instance, FrameRecords& records);
  void saveCellsAndMap(FrameRecords& records);

  Stages stages_;
  Policies policies_;
  Listener& listener_;
  bool place_needs_motion_;
  std::optional<LocalisedMap> localised_;
  std::atomic<bool> can_save_;  // false also after a stage has failed to save its state
  RunCounters counters_;
  StageTimes finish_times_ns_{};
  std::int64_t unanswered_ = -1;  ///< first frame without answers, because a stage failed; -1: none
  std::optional<Failure> failure_;
  std::optional<Failure> input_failure_;
  std::optional<MapScale> scale_;  // none: nothing was tracked so far
  std::int64_t last_skipped_frame_ = -1;
  mutable std::mutex failure_mutex_;
  Motion last_motion_;
  Decision last_decision_;
  MapUpdate last_map_;
  bool graph_has_changed_ = true;      // since it was last published
  std::int64_t next_graph_frame_ = 0;  // the graph is not published before this frame
  std::size_t mapped_ = 0;             // number of frames that the map has processed
  std::size_t admitted_ = 0;
};

// Drives all frames of a source through the stages.

/// Time from when a frame came to its pose in the map, in realtime runs. A recorded frame comes at
/// the pace of the stamps.
struct Latency {
  std::int64_t frames = 0;  ///< number of measured frames; 0 in lossless runs
  double median_ms = 0;
  double p99_ms = 0;
};

struct DriveResult {
  std::optional<Failure> failure;
  bool interrupted = false;  ///< cancellation ended it early; all frames until then are complete
  RunCounters counters;      ///< also whether odometry was lost at the end
  StageTimes finish_times_ns{};  ///< time that finish() of each stage took
  Latency latency{};             ///< of a realtime run
};

/// The number of threads for a setting `threads` (0: all cores).
int concurrency(int threads);

/// Processes all frames and finishes all stages. Stages are finished also after a failure or a
/// cancellation, to keep the results so far. `threads` bounds the parallelism (0: all cores).
DriveResult drive(Chain& chain, const config::PipelineSettings& options, int threads,
                  const Cancellation& cancellation);

}  // namespace tolman::engine
