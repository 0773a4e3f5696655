// SPDX-License-Identifier: BSD-3-Clause
// Calls the roles under the guard, and checks every answer against the contract: frame, stamp,
// order in time, values that can be recorded (values.hpp), and the rules of its role.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "host/instance.hpp"
#include "host/values.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// Checks the `dt` of motions against the stamps of their frames.
class MotionTimes {
 public:
  /// `motion` is the answer to `frame`. Its `dt` must be within a factor of ten of the time since
  /// the previous frame, because some plugins use a nominal rate. The previous frame is the last
  /// one that odometry was given or, if it failed there, the last one that it answered.
  Status check(const Frame& frame, const Motion& motion) const;
  /// To be called after each call, `answered` or not.
  void add(const Frame& frame, bool answered);
  /// The last frame; INT64_MAX if there was none.
  std::int64_t lastFrame() const { return last_frame_; }

 private:
  std::int64_t last_frame_ = INT64_MAX;
  std::int64_t given_ns_ = 0;
  std::int64_t answered_ns_ = 0;
};

/// Owns the instance of a role.
template <class RoleType>
class Stage {
 public:
  explicit Stage(std::unique_ptr<Instance> instance) : instance_(std::move(instance)) {}
  Instance& instance() { return *instance_; }
  const Instance& instance() const { return *instance_; }

 protected:
  /// Calls `work`, a function of the role or one of its methods, under the guard.
  template <class Work, class... A>
  Status call(std::string_view what, std::int64_t frame, const Work& work, A&... arguments) {
    return instance_->call<RoleType>(what, frame, [&](RoleType& role) {
      Status status = std::invoke(work, role, arguments...);
      const bool is_end = status.code() == StatusCode::EndOfStream;
      if (!is_end || std::is_same_v<RoleType, Source>) return status;
      return Status::failed("answered the end of the stream, which only a source has");
    });
  }

  std::unique_ptr<Instance> instance_;
};

class SourceStage : public Stage<Source> {
 public:
  using Stage::Stage;
  /// Checks the number of frames and the cameras (checkRig()).
  Status info(SourceInfo& info);
  /// Checks that frames are 0, 1, 2, ..., stamps increase, true poses were announced by info(),
  /// images fit the rig (checkImages()), and arrays keep their shapes.
  Status next(Frame& frame);
  /// Sets the next frame: after reset() the defaults, after load() those of the saved state.
  void resetChecks(std::int64_t next_frame = 0, std::int64_t last_stamp_ns = 0);
  /// The host's index of the first frame of this session; the plugin counts from 0.
  void startAt(std::int64_t first_frame) { first_frame_ = first_frame; }

 private:
  Status check(const Frame& frame);
  SourceInfo info_;
  ArrayShapes sensors_;
  std::int64_t first_frame_ = 0;
  std::int64_t next_frame_ = 0;  ///< as the plugin counts, from 0
  std::int64_t last_stamp_ns_ = 0;
};

class OdometryStage : public Stage<Odometry> {
 public:
  using Stage::Stage;
  Status track(const Frame& frame, Motion& motion);
  Status finish(std::vector<MotionRevision>& revisions);
  /// As SourceStage::startAt(), because odometry restarts in each session.
  void startAt(std::int64_t first_frame) { first_frame_ = first_frame; }
  /// To be called after reset(), or after a saved state was loaded.
  void resetChecks() { times_ = {}; }

 private:
  Status track(Odometry& odometry, const Frame& frame, Motion& motion) const;
  std::int64_t first_frame_ = 0;
  MotionTimes times_;
};

class PlaceStage : public Stage<Place> {
 public:
  using Stage::Stage;
  /// Constant after configure(); if the plugin throws, PlaceInput::Frame.
  PlaceInput input();
  /// Checks that new template ids have no gaps and that others exist.
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation);
  Status finish() { return call("finish", -1, &Place::finish); }
  /// Sets the number of templates: 0 after reset(), -1 (not known) after a saved state was loaded:
  /// then the next novel answer determines it.
  void resetChecks(std::int64_t templates = 0) { templates_ = templates; }
  /// From now on a novel view is refused (Localiser).
  void localise() { localises_ = true; }

 private:
  std::int64_t templates_ = 0;
  bool localises_ = false;
};

class CellsStage : public Stage<Cells> {
 public:
  using Stage::Stage;
  /// Checks experience ids, as template ids, and the ranges of heading and confidence.
  Status step(const Motion& motion, const PlaceObservation& observation, Decision& decision);
  Status finish() { return call("finish", -1, &Cells::finish); }
  /// Sets the number of experiences: 0 after reset(), or that of a saved state that was loaded.
  void resetChecks(std::int64_t experiences = 0) {
    experiences_ = experiences;
    last_ = experiences == 0 ? -1 : kUnknown;
    templates_ = experiences == 0 ? 0 : INT64_MAX;  // given before; not known
  }
  /// From now on decisions must be those of Localiser.
  void localise() { localises_ = true; }

 private:
  static constexpr std::int64_t kUnknown = -2;
  std::int64_t experiences_ = 0;
  std::int64_t templates_ = 0;  ///< one more than the largest id that was seen
  std::int64_t last_ = -1;      ///< the experience of the last decision
  bool localises_ = false;
};

class MapStage : public Stage<Map> {
 public:
  using Stage::Stage;
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update);
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera);
  /// Also checks the counts and the pose of the last update against the graph; not after finish().
  Status graph(MapGraph& graph);
  Status finish(const std::vector<MotionRevision>& revisions);
  /// This frame and later ones were not recorded: a graph that refers to them is refused.
  void forgetFrom(std::int64_t frame) {
    known_.newest_frame = std::min(known_.newest_frame, frame - 1);
  }
  /// Checks that poseOf() gives the last frame the pose of its update; not after finish().
  Status checkLastPose();
  /// The pose of a frame as poseOf() answered it; null where it is not known.
  using KnownPoses = std::function<const Eigen::Isometry3d*(std::int64_t)>;
  /// Checks the pose of each experience against that of the frame at which it was made.
  Status checkExperiences(const MapGraph& graph, const KnownPoses& pose_of);
  /// To be called after reset(), or after a saved state was loaded.
  void resetChecks() {
    known_ = {};
    last_.reset();
  }

 private:
  KnownMap known_;
  std::optional<MapUpdate> last_;  ///< last update; none when the map may have changed since
};

class ObserverStage : public Stage<Observer> {
 public:
  using Stage::Stage;
  Status begin(const RunInfo& run) { return call("begin", -1, &Observer::begin, run); }
  Status observe(const Snapshot& snapshot) {
    return call("observe", snapshot.frame->frame, &Observer::observe, snapshot);
  }
  Status finish(const MapGraph& graph) { return call("finish", -1, &Observer::finish, graph); }
};

}  // namespace tolman::host
