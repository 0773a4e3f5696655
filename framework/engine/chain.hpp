// SPDX-License-Identifier: BSD-3-Clause
// The stages of a run in the order of the flow, and what happens when one of them fails.
#pragma once

#include <oneapi/tbb/task_arena.h>

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>

#include "config/settings.hpp"
#include "engine/checked_odometry.hpp"
#include "engine/failure.hpp"
#include "engine/frame_records.hpp"
#include "engine/rectified_source.hpp"
#include "host/guard.hpp"
#include "host/stages.hpp"

namespace tolman::engine {

/// Calls `call` and returns its result. While `call` waits for its own parallel loops, its thread
/// takes no tasks of other stages: decoding an image in the meantime would delay the answer and all
/// stages that wait for it.
template <class Call>
auto withoutOtherTasks(Call&& call) {
  return tbb::this_task_arena::isolate(call);
}

/// Which stages work at this moment, and since when, ns of the steady clock; 0 while they wait.
using StageActivity = std::array<std::atomic<std::int64_t>, kRoleNames.size()>;

/// Marks a role as working while this object exists, and then adds that time to `times`.
class StageTimer {
 public:
  StageTimer(StageActivity& activity, StageTimes& times, Role role)
      : since_(activity[static_cast<std::size_t>(role)]),
        time_(times[static_cast<std::size_t>(role)]),
        start_(now()) {
    since_ = start_;
  }
  ~StageTimer() {
    since_ = 0;
    time_ += now() - start_;
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  static std::int64_t now() {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
  }
  std::atomic<std::int64_t>& since_;
  std::int64_t& time_;
  std::int64_t start_;
};

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
  /// Number of admitted frames that wait for place recognition.
  int placeBacklog() const { return place_backlog_; }
  /// Time that finish() of each stage took.
  const StageTimes& finishTimes() const { return finish_times_ns_; }
  /// The stages that are being called at this moment, the source and finish() included.
  const StageActivity& stageActivity() const { return activity_; }
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
  Status readTrajectory(std::vector<FramePose>& poses) const;
  Status finalGraph(const std::vector<FramePose>& poses, MapGraph& graph);
  /// Calls `work`, marks the role as active during the call, and adds its time to `times`.
  template <class Work>
  Status timed(StageTimes& times, Role role, const Work& work) {
    const StageTimer timer(activity_, times, role);
    return work();
  }
  void save(Role role, host::Instance& instance, FrameRecords& records);
  void saveCellsAndMap(FrameRecords& records);

  Stages stages_;
  Policies policies_;
  Listener& listener_;
  bool place_needs_motion_;
  std::atomic<bool> can_save_;  // false also after a stage has failed to save its state
  RunCounters counters_;
  StageActivity activity_{};
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
  std::atomic<int> place_backlog_ = 0;
};

}  // namespace tolman::engine
