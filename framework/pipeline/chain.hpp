// SPDX-License-Identifier: BSD-3-Clause
// The stages of a run in the order of the flow, and what happens when one of them fails.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include "config/settings.hpp"
#include "pipeline/failure_tally.hpp"
#include "pipeline/listener.hpp"
#include "pipeline/packet.hpp"
#include "plugins/stages.hpp"

namespace tolman::pipeline {

struct Policies {
  config::FailurePolicy odometry = config::FailurePolicy::Stop;
  config::FailurePolicy place = config::FailurePolicy::Stop;
  config::FailurePolicy cells = config::FailurePolicy::Stop;
  config::FailurePolicy map = config::FailurePolicy::Stop;
};

struct Stages {
  plugins::SourceStage& source;
  plugins::OdometryStage& odometry;
  plugins::PlaceStage& place;
  plugins::CellsStage& cells;
  plugins::MapStage& map;
};

/// Health of a run, to be read before any error figure.
struct Counters {
  std::int64_t frames = 0;   ///< processed
  std::int64_t dropped = 0;  ///< realtime: never processed
  std::int64_t skipped = 0;  ///< answers replaced because a plugin failed, by `on_failure: skip`
  std::int64_t defects = 0;  ///< frames without a sound image
  std::int64_t lost = 0;     ///< frames with odometry lost
  std::int64_t place_left_out = 0;
  std::int64_t templates = 0;  ///< with those of sessions before, as the map
  std::int64_t experiences = 0;
  std::int64_t links = 0;
  std::int64_t loops = 0;
  bool lost_at_end = false;
};

/// The work of each stage on one packet. odometry() and place() may run at the same time; think()
/// and tell() each one packet at a time and in order.
class Chain {
 public:
  /// The stages are configured.
  Chain(const Stages& stages, const Policies& policies, Listener& listener)
      : stages_(stages),
        policies_(policies),
        listener_(listener),
        place_needs_motion_(stages.place.input() == PlaceInput::FrameAndMotion) {}

  void odometry(Packet& packet);
  void place(Packet& packet);
  /// Cells and map. After a failure all later packets pass untouched.
  void think(Packet& packet);
  /// Recorder and observers. After a failure of theirs, too, they hear of the frames that the map
  /// has taken up already.
  void tell(const Packet& packet);
  /// finish() of all stages, in the order of the flow.
  void finish();

  /// The first failure of a stage, if there is one; no later frame is answered.
  std::optional<Status> failure() const;
  bool failed() const { return failure().has_value(); }
  void fail(const Status& status);
  /// The source failed: frames that it gave before are still processed.
  void failInput(const Status& status);
  /// What the run ends with: a stage's failure, else the source's, else Ok.
  Status result() const;
  /// Whether a packet passes odometry before place recognition.
  bool placeNeedsMotion() const { return place_needs_motion_; }
  /// Numbers a packet that now goes in; one call at a time.
  void admit(Packet& packet);
  /// Frames that went in and have not passed place recognition.
  int placeBacklog() const { return place_backlog_; }
  /// What finish() took of each stage.
  const StageTimes& finishTimes() const { return finish_times_ns_; }
  const Counters& counters() const { return counters_; }
  Counters& counters() { return counters_; }
  Stages& stages() { return stages_; }
  Listener& listener() { return listener_; }

 private:
  bool resolve(const Status& status, config::FailurePolicy policy, std::int64_t frame,
               std::string_view role);
  bool takeOdometry(Packet& packet);
  bool takePlace(Packet& packet);
  bool decide(Packet& packet);
  bool map(Packet& packet);
  void publishGraph(Packet& packet);
  void count(const Packet& packet);
  void tellTrajectory();

  Stages stages_;
  Policies policies_;
  Listener& listener_;
  bool place_needs_motion_;
  Counters counters_;
  StageTimes finish_times_ns_{};
  std::optional<Status> failure_;
  std::optional<Status> input_failure_;
  FailureTally failures_;  // by role
  mutable std::mutex failure_mutex_;
  Motion last_motion_;
  Decision last_decision_;
  MapUpdate last_map_;
  bool graph_is_news_ = true;          // it has changed since it was last published
  std::int64_t next_graph_frame_ = 0;  // not published before
  std::size_t admitted_ = 0;
  std::atomic<int> place_backlog_ = 0;
};

}  // namespace tolman::pipeline
