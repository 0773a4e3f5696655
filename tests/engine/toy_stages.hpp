// SPDX-License-Identifier: BSD-3-Clause
// Five tiny stages in memory, a listener that stores all records, and a function to run them.
#pragma once

#include <atomic>
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <mutex>
#include <vector>

#include "engine/chain.hpp"
#include "support/context.hpp"
#include "tolman/plugin.hpp"

namespace tolman::test {

/// What a test may change in the toys: called inside the stage, with the frame.
struct Hooks {
  std::int64_t frames = 30;
  std::function<Status(std::int64_t)> source, odometry, place, cells, map, pose_of;
  std::function<Status(std::int64_t)> graph;      ///< called with the number of experiences
  std::function<bool(std::int64_t)> scale_known;  ///< of the motion at a frame; null: of all
  bool place_needs_motion = false;
  std::function<void()> map_finish;
  double step_m = 1e-3;            ///< of odometry in a frame, which takes 1 ms
  bool keeps_state = false;        ///< place, cells and map are StateKeepers
  bool cells_cannot_save = false;  ///< although they are
  bool map_grows = false;          ///< by an experience a frame, else it has one
  std::atomic<int> input_asked = 0;
  std::atomic<int> finished = 0;

  static Status call(const std::function<Status(std::int64_t)>& hook, std::int64_t frame) {
    return hook ? hook(frame) : Status::ok();
  }
};

struct ToySource : Source {
  explicit ToySource(Hooks& h) : hooks(h) {}
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status info(SourceInfo&) override { return Status::ok(); }
  Status next(Frame& frame) override {
    if (index == hooks.frames) return Status::endOfStream();
    frame.frame = index++;
    frame.stamp_ns = frame.frame * 1'000'000;
    return Hooks::call(hooks.source, frame.frame);
  }
  Hooks& hooks;
  std::int64_t index = 0;
};

/// State that depends on the order of frames: any disorder changes all later answers.
struct ToyOdometry : Odometry {
  explicit ToyOdometry(Hooks& h) : hooks(h) {}
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status track(const Frame& frame, Motion& motion) override {
    motion.frame = frame.frame;
    motion.stamp_ns = frame.stamp_ns;
    if (frame.frame > 0) motion.state = TrackingState::Tracking;
    motion.dt = last_ns < 0 ? 0 : 1e-9 * static_cast<double>(frame.stamp_ns - last_ns);
    last_ns = frame.stamp_ns;
    state = 0.9 * state + static_cast<double>(frame.frame);
    motion.v = state;
    if (hooks.scale_known) motion.scale_known = hooks.scale_known(frame.frame);
    if (frame.frame > 0) motion.T_previous_current.translation().z() = hooks.step_m;
    return Hooks::call(hooks.odometry, frame.frame);
  }
  Status finish(std::vector<MotionRevision>& revisions) override {
    ++hooks.finished;
    revisions.emplace_back().frame = 0;
    return Status::ok();
  }
  Hooks& hooks;
  double state = 0;
  std::int64_t last_ns = -1;
};

/// A metre a frame at 10 Hz, but at frame 3 a hundred; each frame revises the one before.
struct LeapingOdometry : Odometry {
  explicit LeapingOdometry(Hooks&) {}
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status track(const Frame& frame, Motion& motion) override {
    motion.frame = frame.frame;
    motion.stamp_ns = frame.stamp_ns;
    motion.state = frame.frame == 0 ? TrackingState::Initialising : TrackingState::Tracking;
    motion.T_previous_current.translation().z() = frame.frame == 0 ? 0 : frame.frame == 3 ? 100 : 1;
    setPlanarVelocity(motion, frame.frame == 0 ? 0 : 0.1);
    if (frame.frame > 0) motion.revisions.emplace_back().frame = frame.frame - 1;
    return Status::ok();
  }
  Status finish(std::vector<MotionRevision>& revisions) override {
    revisions.emplace_back().frame = 2;
    revisions.emplace_back().frame = 3;
    return Status::ok();
  }
};

/// A state of one number, which saving may refuse.
template <class T>
struct ToyState : StateKeeper {
  Status save(std::ostream& stream) const override {
    if (refuses) return Status::failed("no pen");
    stream.write(reinterpret_cast<const char*>(&value), sizeof value);
    return Status::ok();
  }
  Status load(std::istream& stream) override {
    stream.read(reinterpret_cast<char*>(&value), sizeof value);
    return stream ? Status::ok() : Status::invalidInput("too short");
  }
  T value{};
  bool refuses = false;
};

struct ToyPlace : Place, ToyState<std::int64_t> {
  explicit ToyPlace(Hooks& h) : hooks(h) {}
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  PlaceInput input() const override {
    ++hooks.input_asked;
    return hooks.place_needs_motion ? PlaceInput::FrameAndMotion : PlaceInput::Frame;
  }
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& place) override {
    place.frame = frame.frame;
    place.stamp_ns = frame.stamp_ns;
    place.recognition = Recognition::Novel;
    place.template_id = value++;
    if (motion != nullptr) place.score = motion->v;
    return Hooks::call(hooks.place, frame.frame);
  }
  Status finish() override {
    ++hooks.finished;
    return Status::ok();
  }
  Hooks& hooks;
};

/// Its heading counts the frames.
struct ToyCells : Cells, ToyState<std::int64_t> {
  explicit ToyCells(Hooks& h) : hooks(h) { refuses = h.cells_cannot_save; }
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status step(const Motion& motion, const PlaceObservation& place, Decision& decision) override {
    decision.frame = motion.frame;
    decision.stamp_ns = motion.stamp_ns;
    decision.template_id = place.template_id;
    decision.experience = 0;
    decision.heading = 0.001 * static_cast<double>(++value % 1000);
    decision.action = motion.frame == 0 ? Action::CreateExperience : Action::Stay;
    return Hooks::call(hooks.cells, motion.frame);
  }
  Status finish() override {
    ++hooks.finished;
    return Status::ok();
  }
  Hooks& hooks;
};

struct ToyMap : Map, ToyState<double> {
  explicit ToyMap(Hooks& h) : hooks(h) {}
  Status configure(const Context&) override { return Status::ok(); }
  Status reset() override { return Status::ok(); }
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update) override {
    update.frame = motion.frame;
    update.stamp_ns = motion.stamp_ns;
    update.experience = decision.experience;
    value += motion.v;
    // Shorter than the path of odometry: it says which motions were taken, and is no position.
    update.T_world_camera.translation().z() = z[motion.frame] = 1e-6 * value;
    update.T_experience_camera = update.T_world_camera;  // of the first, at the origin
    experiences = hooks.map_grows ? motion.frame + 1 : 1;
    update.experiences = experiences;
    return Hooks::call(hooks.map, motion.frame);
  }
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const override {
    T_world_camera = knownPose(frame);
    return Hooks::call(hooks.pose_of, frame);
  }
  Status graph(MapGraph& graph) const override {
    for (std::int64_t id = 0; id < experiences; ++id) {
      graph.experiences.push_back({id, id, -1, knownPose(id)});
    }
    return Hooks::call(hooks.graph, experiences);
  }
  Eigen::Isometry3d knownPose(std::int64_t frame) const {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    const auto found = z.find(frame);
    if (found != z.end()) T.translation().z() = found->second;
    return T;
  }
  Status finish(const std::vector<MotionRevision>&) override {
    ++hooks.finished;
    if (hooks.map_finish) hooks.map_finish();
    return Status::ok();
  }
  Hooks& hooks;
  std::int64_t experiences = 1;
  std::map<std::int64_t, double> z;  ///< by frame; not saved
};

/// Stores all events and frames, for comparison.
struct Diary : engine::Listener {
  struct Entry {
    std::int64_t frame;
    double v;
    std::int64_t template_id;
    double score;
    double z;
    double heading;
    bool lost;
    bool operator==(const Entry&) const = default;
  };
  Status onFrame(const Snapshot& s) override {
    entries.push_back({s.frame->frame, s.motion->v, s.place->template_id, s.place->score,
                       s.map->T_world_camera.translation().z(), s.decision->heading,
                       s.motion->state == TrackingState::Lost});
    if (s.graph != nullptr) graphs.emplace_back(s.frame->frame, s.graph->experiences.size());
    return on_frame ? on_frame(s.frame->frame) : Status::ok();
  }
  void onEvent(const engine::Event& event) override {
    const std::lock_guard lock(mutex);
    events.push_back(event);
  }
  bool checkpointDue() override { return checkpoint_each_frame; }
  Status onCheckpoint(const engine::Checkpoint& checkpoint) override {
    CHECK(checkpoint.frame == entries.back().frame);
    checkpoints.push_back(checkpoint);
    return Status::ok();
  }
  Status onFinish(const std::vector<MotionRevision>& r, const MapGraph& graph) override {
    revisions = r.size();
    final_size = graph.experiences.size();
    return Status::ok();
  }
  std::function<Status(std::int64_t)> on_frame;
  bool checkpoint_each_frame = false;
  std::vector<engine::Checkpoint> checkpoints;
  std::vector<Entry> entries;
  std::vector<engine::Event> events;
  std::vector<std::pair<std::int64_t, std::size_t>> graphs;  ///< frame, experiences
  std::size_t revisions = 0;
  std::size_t final_size = 0;
  std::mutex mutex;
};

struct Flag : Cancellation {
  bool requested() const override { return set; }
  std::atomic<bool> set = false;
};

template <class Toy>
PluginObject objectOf(Hooks& hooks) {
  auto* toy = new Toy(hooks);
  PluginObject object{toy};
  if constexpr (std::is_base_of_v<StateKeeper, Toy>) {
    if (hooks.keeps_state) object.state = toy;
  }
  return object;
}

/// A guarded instance around an object that the test made.
template <class Toy>
std::unique_ptr<host::Instance> guardedToy(Hooks& hooks, const char* name) {
  static thread_local Hooks* current = nullptr;
  current = &hooks;
  static constexpr PluginDescriptor kDescriptor = {TOLMAN_SDK_MAJOR,
                                                   TOLMAN_SDK_MINOR,
                                                   "toy",
                                                   detail::roleOf<Toy>(),
                                                   0,
                                                   &schemaOf<NoParameters>,
                                                   [] { return objectOf<Toy>(*current); },
                                                   [](Plugin* plugin) { delete plugin; }};
  host::LoadedPlugin loaded;
  loaded.manifest.id = "toy";
  loaded.descriptor = &kDescriptor;
  return host::Instance::create(loaded, name);
}

/// Five toys, wired up.
struct ToySystem {
  explicit ToySystem(Hooks& hooks)
      : source(guardedToy<ToySource>(hooks, "source")),
        odometry(guardedToy<ToyOdometry>(hooks, "odometry")),
        place(guardedToy<ToyPlace>(hooks, "place")),
        cells(guardedToy<ToyCells>(hooks, "cells")),
        map(guardedToy<ToyMap>(hooks, "map")) {}

  engine::DriveResult drive(const config::PipelineSettings& settings, int threads,
                            const engine::Policies& policies = {}) {
    engine::Chain chain({source, checked_odometry, place, cells, map}, policies, diary);
    return engine::drive(chain, settings, threads, flag);
  }

  engine::RectifiedSource source;
  host::OdometryStage odometry;
  engine::CheckedOdometry checked_odometry{odometry, config::CheckSettings()};
  host::PlaceStage place;
  host::CellsStage cells;
  host::MapStage map;
  Diary diary;
  Flag flag;
};

}  // namespace tolman::test
