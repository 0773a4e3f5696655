// SPDX-License-Identifier: BSD-3-Clause
// The stages of a run in the order of the flow, and what happens when one of them fails.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string_view>

#include "config/settings.hpp"
#include "host/stages.hpp"
#include "pipeline/failure_tally.hpp"
#include "pipeline/frame_records.hpp"
#include "pipeline/listener.hpp"

namespace tolman::pipeline {

struct Policies {
  config::FailurePolicy odometry = config::FailurePolicy::Stop;
  config::FailurePolicy place = config::FailurePolicy::Stop;
  config::FailurePolicy cells = config::FailurePolicy::Stop;
  config::FailurePolicy map = config::FailurePolicy::Stop;
};

struct Stages {
  host::SourceStage& source;
  host::OdometryStage& odometry;
  host::PlaceStage& place;
  host::CellsStage& cells;
  host::MapStage& map;
};

/// Health of a run, to be read before any error figure.
struct RunCounters {
  std::int64_t frames = 0;          ///< processed
  std::int64_t dropped = 0;         ///< realtime: never processed
  std::int64_t skipped = 0;         ///< failures after which the run continued
  std::int64_t defects = 0;         ///< frames without a sound image
  std::int64_t initialising = 0;    ///< frames before odometry gave a motion; at least the first
  std::int64_t lost = 0;            ///< frames with odometry lost
  std::int64_t place_left_out = 0;  ///< realtime: frames without place recognition
  std::int64_t loop_decisions = 0;  ///< Action::CloseLoop, also those that the map rejects later
  std::int64_t templates = 0;       ///< with those of earlier sessions
  std::int64_t experiences = 0;     ///< of the newest published graph, at the end the final one
  std::int64_t links = 0;           ///< of the same graph, without rejected ones
  std::int64_t loop_links = 0;      ///< those of kind LinkKind::Loop
  bool lost_at_end = false;

  std::int64_t tracked() const { return frames - initialising - lost; }
  /// Whether no motion was found in the whole run.
  bool neverTracked() const { return frames > 1 && tracked() == 0; }
};

inline constexpr std::string_view kNeverTracked =
    "no motion in the whole run; are the images rectified, and left and right not exchanged? see "
    "`tolman dataset check`";

/// What stopped a run.
struct StageFailure {
  Role role = Role::Source;  ///< Observer: the listener, i.e. recorder or observers
  Status status;
};

/// The work of each stage on one frame. odometry() and place() may run at the same time;
/// runCellsAndMap() and publish() take one frame at a time, in order.
class Chain {
 public:
  /// The stages must be configured already.
  Chain(const Stages& stages, const Policies& policies, Listener& listener)
      : stages_(stages),
        policies_(policies),
        listener_(listener),
        place_needs_motion_(stages.place.input() == PlaceInput::FrameAndMotion) {}

  void odometry(FrameRecords& records);
  void place(FrameRecords& records);
  /// After a failure, later frames are not processed and get no answers.
  void runCellsAndMap(FrameRecords& records);
  /// Hands the answers to the listener. Frames that the map processed before a failure are still
  /// handed over, even if the listener itself has failed.
  void publish(const FrameRecords& records);
  /// finish() of all stages, in the order of the flow.
  void finish();

  /// Whether a stage or the listener failed; no later frame is answered.
  bool failed() const;
  void fail(Role role, const Status& status);
  /// The source failed: frames that it gave before are still processed.
  void failInput(const Status& status);
  /// What stopped the run: a stage's failure, else the source's, else nothing.
  std::optional<StageFailure> failure() const;
  /// Whether a frame passes odometry before place recognition.
  bool placeNeedsMotion() const { return place_needs_motion_; }
  /// Numbers a frame that enters the stages; one call at a time.
  void admit(FrameRecords& records);
  /// Frames that entered and wait for place recognition.
  int placeBacklog() const { return place_backlog_; }
  /// Time that finish() of each stage took.
  const StageTimes& finishTimes() const { return finish_times_ns_; }
  const RunCounters& counters() const { return counters_; }
  RunCounters& counters() { return counters_; }
  Stages& stages() { return stages_; }
  Listener& listener() { return listener_; }

 private:
  bool resolve(const Status& status, config::FailurePolicy policy, std::int64_t frame, Role role);
  bool takeOdometry(FrameRecords& records);
  bool takePlace(FrameRecords& records);
  bool decide(FrameRecords& records);
  bool map(FrameRecords& records);
  void publishGraph(FrameRecords& records);
  void count(const FrameRecords& records);
  void countGraph(const MapGraph& graph);
  void publishTrajectory();

  Stages stages_;
  Policies policies_;
  Listener& listener_;
  bool place_needs_motion_;
  RunCounters counters_;
  StageTimes finish_times_ns_{};
  std::optional<StageFailure> failure_;
  std::optional<Status> input_failure_;
  FailureTally failures_;  // by role
  mutable std::mutex failure_mutex_;
  Motion last_motion_;
  Decision last_decision_;
  MapUpdate last_map_;
  bool graph_has_changed_ = true;      // since it was last published
  std::int64_t next_graph_frame_ = 0;  // not published before
  std::size_t admitted_ = 0;
  std::atomic<int> place_backlog_ = 0;
};

}  // namespace tolman::pipeline
