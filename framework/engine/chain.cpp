// SPDX-License-Identifier: BSD-3-Clause
#include "engine/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "engine/camera_check.hpp"

namespace tolman::engine {

namespace {

// A graph below kGraphSizePerFrame is published at every change; a larger one at most every n-th
// frame, with n in proportion to its size, and above kLargeGraph to the cube of its size, but at
// most kRarest: then all that a long run publishes costs less than driving it. Experiences and
// links; chosen, not tuned.
constexpr std::size_t kGraphSizePerFrame = 400;
constexpr std::size_t kLargeGraph = 8'000;
constexpr std::size_t kRarest = 20'000;

/// A record with default values, for this frame.
template <Record R>
R blankOf(const Frame& frame) {
  R record;
  record.frame = frame.frame;
  record.stamp_ns = frame.stamp_ns;
  return record;
}

}  // namespace

bool Chain::failed() const {
  const std::lock_guard lock(failure_mutex_);
  return failure_.has_value();
}

void Chain::failBy(Role role, const Status& status) {
  listener_.onEvent({-1, LogLevel::Error, std::string(enumName(role)), status.message()});
  fail(role, status);
}

void Chain::fail(Role role, const Status& status) {
  const FailureKind usual = role == Role::Source ? FailureKind::Dataset : FailureKind::Stage;
  const std::lock_guard lock(failure_mutex_);
  if (!failure_) failure_ = {kindOf(status, usual), status.message(), nameOf(role)};
}

std::string Chain::nameOf(Role role) const {
  if (role == Role::Observer) return listener_.failedStage();
  const std::array<const host::Instance*, 5> instances = {
      &stages_.source.instance(), &stages_.odometry.instance(), &stages_.place.instance(),
      &stages_.cells.instance(), &stages_.map.instance()};
  return instances.at(static_cast<std::size_t>(role))->name();
}

std::optional<Failure> Chain::failure() const {
  const std::lock_guard lock(failure_mutex_);
  return failure_ ? failure_ : input_failure_;
}

bool Chain::applyPolicy(const Status& status, std::int64_t frame, Role role) {
  if (status.isOk()) return true;
  if (stopsFor(role)) {
    listener_.onEvent({frame, LogLevel::Error, std::string(enumName(role)), status.message()});
    fail(role, status);
    return false;
  }
  if (frame >= 0 && std::exchange(last_skipped_frame_, frame) != frame) ++counters_.skipped;
  warn(frame, role, status.message() + (frame < 0 ? "; the run continues" : "; frame skipped"));
  return true;
}

void Chain::warn(std::int64_t frame, Role role, const std::string& text) {
  listener_.onEvent({frame, LogLevel::Warning, std::string(enumName(role)), text});
}

FrameRecordsPtr Chain::readFrame(const Cancellation& cancellation) {
  if (failed() || cancellation.requested()) return nullptr;
  auto records = std::make_shared<FrameRecords>();
  const Status status =
      timed(records->times, Role::Source, [&] { return stages_.source.next(records->frame); });
  if (status.isOk()) return records;
  if (status.code() == StatusCode::EndOfStream ||
      (status.code() == StatusCode::Cancelled && cancellation.requested())) {
    return nullptr;
  }
  listener_.onEvent({-1, LogLevel::Error, "source", status.message()});
  const std::lock_guard lock(failure_mutex_);
  input_failure_ = {kindOf(status, FailureKind::Dataset), status.message(), nameOf(Role::Source)};
  return nullptr;
}

void Chain::admit(FrameRecords& records) {
  records.sequence = admitted_++;
  if (const auto fault = stages_.odometry.admit(records.frame)) {
    listener_.onEvent({records.frame.frame, LogLevel::Warning, "images", *fault});
  }
  if (can_save_ && listener_.checkpointDue()) records.checkpoint = std::make_unique<Checkpoint>();
}

void Chain::odometry(FrameRecords& records) {
  if (failed()) return;
  records.odometry_status = timed(records.times, Role::Odometry, [&] {
    return withoutOtherTasks(
        [&] { return stages_.odometry.track(records.frame, records.motion, records.impossible); });
  });
}

void Chain::place(FrameRecords& records) {
  if (failed()) return;
  records.place = blankOf<PlaceObservation>(records.frame);
  const Motion* motion = place_needs_motion_ ? &records.motion : nullptr;
  records.place_status = timed(records.times, Role::Place, [&] {
    return withoutOtherTasks(
        [&] { return stages_.place.observe(records.frame, motion, records.place); });
  });
  save(Role::Place, stages_.place.instance(), records);
}

bool Chain::acceptMotion(FrameRecords& records) {
  const Status& status = records.odometry_status;
  if (!applyPolicy(status, records.frame.frame, Role::Odometry)) return false;
  if (!status.isOk()) records.motion = predictedMotion(records.frame, last_motion_);
  reportImpossible(records.frame.frame, records.impossible);
  if (!acceptScale(records.motion)) return false;
  last_motion_ = records.motion;
  return true;
}

/// Lengths of another unit than those of the earlier session end the run, whatever the policy of
/// odometry: its map would have two units. Within a run there is a warning. Only tracked motions
/// are compared: others have no lengths, or are predicted.
bool Chain::acceptScale(const Motion& motion) {
  if (motion.state != TrackingState::Tracking) return true;
  const auto before = std::exchange(scale_, MapScale{motion.scale_known, {}});
  if (!before || before->is_known == motion.scale_known) return true;
  const auto unit = [](bool is_known) {
    return is_known ? "metres (scale_known is true)" : "arbitrary units (scale_known is false)";
  };
  if (before->session.empty()) {
    warn(motion.frame, Role::Odometry,
         fmt::format("the lengths of this motion are in {}, those before in {}; the map joins both "
                     "as if they were of one unit, so its lengths and errors mean nothing: answer "
                     "`initialising` until the scale is known",
                     unit(motion.scale_known), unit(before->is_known)));
    return true;
  }
  const std::string text = fmt::format(
      "frame {}: odometry gives lengths in {}, and the map of the earlier session {} "
      "has lengths in {}; continue it with an odometry of the same kind, or begin a "
      "new map without --continue",
      motion.frame, unit(motion.scale_known), before->session, unit(before->is_known));
  listener_.onEvent({motion.frame, LogLevel::Error, "odometry", text});
  const std::lock_guard lock(failure_mutex_);
  if (!failure_) failure_ = {FailureKind::Continuation, text, nameOf(Role::Odometry)};
  return false;
}

void Chain::reportImpossible(std::int64_t frame, const std::vector<std::string>& texts) {
  counters_.impossible += std::ssize(texts);
  for (const std::string& text : texts) warn(frame, Role::Odometry, text);
}

bool Chain::acceptObservation(FrameRecords& records) {
  const Status& status = records.place_status;
  if (!applyPolicy(status, records.frame.frame, Role::Place)) return false;
  if (status.isOk()) return true;
  records.place = blankOf<PlaceObservation>(records.frame);
  return true;
}

bool Chain::runCells(FrameRecords& records) {
  Status arrays;
  const Status status = timed(records.times, Role::Cells, [&] {
    Status stepped = stages_.cells.step(records.motion, records.place, records.decision);
    if (stepped.isOk()) {
      arrays = stages_.cells.instance().arrays(records.frame.frame, records.cells);
    }
    return stepped;
  });
  if (!applyPolicy(status, records.frame.frame, Role::Cells)) return false;
  // With skip or restart the decision is kept if the arrays cannot be read.
  if (!applyPolicy(arrays, records.frame.frame, Role::Cells)) return false;
  if (!arrays.isOk()) records.cells.clear();
  if (!status.isOk()) {
    records.decision = blankOf<Decision>(records.frame);
    records.decision.experience = last_decision_.experience;
    records.decision.heading = last_decision_.heading;
  }
  last_decision_ = records.decision;
  return true;
}

bool Chain::runMap(FrameRecords& records) {
  const Status status = timed(records.times, Role::Map, [&] {
    if (!localised_) return stages_.map.update(records.motion, records.decision, records.map);
    records.map = localised_->update(records.motion, records.decision);
    return Status::ok();
  });
  if (!applyPolicy(status, records.frame.frame, Role::Map)) return false;
  if (!status.isOk()) {  // the last experience, and the last pose moved by the motion
    const Eigen::Isometry3d& step = records.motion.T_previous_current;
    records.map = last_map_;
    records.map.frame = records.frame.frame;
    records.map.stamp_ns = records.frame.stamp_ns;
    records.map.T_experience_camera = last_map_.T_experience_camera * step;
    records.map.T_world_camera = last_map_.T_world_camera * step;
  } else {
    ++mapped_;
  }
  publishGraph(records);
  last_map_ = records.map;
  return true;
}

/// Copying, checking and storing a graph costs time in proportion to its size, and an odometry that
/// revises its last motions changes the map at every frame. Publishing at intervals in proportion
/// to the size bounds the cost per frame for runs of any length. A delayed change is published
/// later, at the latest by finish().
void Chain::publishGraph(FrameRecords& records) {
  const MapUpdate& now = records.map;
  graph_has_changed_ = graph_has_changed_ || now.version != last_map_.version ||
                       now.experiences != last_map_.experiences || now.links != last_map_.links;
  if (!graph_has_changed_ || now.frame < next_graph_frame_) return;
  graph_has_changed_ = false;
  const Status status = stages_.map.graph(records.graph);
  records.graph_changed = applyPolicy(status, now.frame, Role::Map) && status.isOk();
  if (records.graph_changed) countGraph(records.graph);
  const std::size_t size = records.graph.experiences.size() + records.graph.links.size();
  const std::size_t rarer = std::max<std::size_t>(1, size / kLargeGraph);
  const std::size_t wait = std::min(kRarest, size / kGraphSizePerFrame * rarer * rarer);
  next_graph_frame_ = now.frame + 1 + static_cast<std::int64_t>(wait);
}

void Chain::runCellsAndMap(FrameRecords& records) {
  if (failed()) return;
  records.answered = acceptMotion(records) && acceptObservation(records) && runCells(records) &&
                     runMap(records) && !failed();
  if (!records.answered) {
    unanswered_ = records.frame.frame;
    return;
  }
  records.posed = std::chrono::steady_clock::now();
  count(records);
  saveCellsAndMap(records);
}

/// Each stage is saved directly after it has processed the frame, so that the flow need not stop.
void Chain::save(Role role, host::Instance& instance, FrameRecords& records) {
  if (!records.checkpoint) return;
  Result<std::string> state = instance.save();
  if (state.isOk()) {
    records.checkpoint->states[role] = std::move(state).value();
    return;
  }
  records.checkpoint.reset();
  if (!can_save_.exchange(false)) return;  // warns once; other frames may be in the flow
  warn(records.frame.frame, role,
       "this run saves no further checkpoints: " + state.status().message());
}

void Chain::saveCellsAndMap(FrameRecords& records) {
  save(Role::Cells, stages_.cells.instance(), records);
  save(Role::Map, stages_.map.instance(), records);
  if (!records.checkpoint) return;
  records.checkpoint->frame = records.frame.frame;
  records.checkpoint->counters = counters_;
}

void Chain::saveNow() {
  if (failed() || !can_save_ || last_map_.frame < 0) return;
  FrameRecords records;
  records.frame.frame = last_map_.frame;
  records.checkpoint = std::make_unique<Checkpoint>();
  save(Role::Place, stages_.place.instance(), records);
  saveCellsAndMap(records);
  if (!records.checkpoint) return;
  const Status status = listener_.onCheckpoint(*records.checkpoint);
  if (!status.isOk()) fail(Role::Observer, status);
}

void Chain::resume(const ResumePoint& point) {
  counters_ = point.checkpoint.counters;
  last_motion_ = point.motion;
  last_decision_ = point.decision;
  last_map_ = point.map;
  if (point.scale) scale_ = point.scale;
}

void Chain::count(const FrameRecords& records) {
  ++counters_.frames;
  if (!records.frame.defect.empty()) ++counters_.defects;
  const bool lost = records.motion.state == TrackingState::Lost;
  if (lost) ++counters_.lost;
  if (records.motion.state == TrackingState::Initialising) ++counters_.initialising;
  const bool tracking = records.motion.state == TrackingState::Tracking;
  if (!tracking && isNearlyBlack(records.frame.left)) ++counters_.nearly_black;
  const auto& motion = records.motion.T_previous_current.matrix();
  if (tracking && motion == Eigen::Matrix4d::Identity()) ++counters_.unmoved;
  if (lost != counters_.lost_at_end) {
    listener_.onEvent({records.frame.frame, lost ? LogLevel::Warning : LogLevel::Info, "odometry",
                       lost ? "tracking lost; motion is predicted" : "tracking recovered"});
  }
  counters_.lost_at_end = lost;
  counters_.templates = std::max(counters_.templates, records.place.template_id + 1);
  if (records.decision.action == Action::CloseLoop) ++counters_.loop_decisions;
}

void Chain::countGraph(const MapGraph& graph) {
  counters_.experiences = static_cast<std::int64_t>(graph.experiences.size());
  counters_.links = counters_.loop_links = 0;
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    ++counters_.links;
    if (link.kind == LinkKind::Loop) ++counters_.loop_links;
  }
}

void Chain::publish(FrameRecords& records) {
  // Publishes also after a failure of the listener: the map has processed the frames that were in
  // the flow, and its graph and trajectory contain them.
  if (!records.answered) return;
  Status status = listener_.onFrame(records.snapshot());
  if (status.isOk() && records.checkpoint) status = listener_.onCheckpoint(*records.checkpoint);
  if (!status.isOk()) fail(Role::Observer, status);
}

/// The poses are read from the map again, because a map that rejects a loop link also moves the
/// frames that were attached to an experience by it.
Status Chain::readTrajectory(std::vector<record::FinalPose>& poses) const {
  const std::int64_t last = localised_ ? localised_->firstFrame() - 1 : last_map_.frame;
  for (std::int64_t frame = 0; frame <= last; ++frame) {
    record::FinalPose pose{frame, Eigen::Isometry3d::Identity()};
    const Status status = stages_.map.poseOf(frame, pose.T_world_camera);
    if (status.isOk()) poses.push_back(pose);
    const bool is_unknown = status.code() == StatusCode::InvalidParameter;  // dropped, for example
    if (!status.isOk() && !(is_unknown && frame < last_map_.frame)) return status;
  }
  if (localised_ || poses.size() >= mapped_) return Status::ok();
  return Status::failed("poseOf() has no pose for " + std::to_string(mapped_ - poses.size()) +
                        " frames that update() accepted; the trajectories lack them");
}

/// Checked against the final poses.
Status Chain::finalGraph(const std::vector<record::FinalPose>& poses, MapGraph& graph) {
  const Status status = stages_.map.graph(graph);
  if (!status.isOk()) return status;
  return stages_.map.checkExperiences(graph, [&](std::int64_t frame) -> const Eigen::Isometry3d* {
    const auto found = std::ranges::lower_bound(poses, frame, {}, &record::FinalPose::frame);
    return found == poses.end() || found->frame != frame ? nullptr : &found->T_world_camera;
  });
}

void Chain::completeCounters() {
  // An odometry that is Initialising again at the end, after it has tracked, counts as lost.
  const bool starting = last_motion_.state == TrackingState::Initialising;
  if (starting && counters_.tracked() > 0) counters_.lost_at_end = true;
  if (counters_.dropped > 0) {
    listener_.onEvent(
        {-1, LogLevel::Warning, "pipeline",
         "frames were dropped: the .kitti files repeat the pose before them, the .tum "
         "files leave them out"});
  }
  if (failed()) return;  // that is why there was no motion, or no more of it
  if (const std::string_view cause = counters_.endText(); !cause.empty()) {
    warn(-1, Role::Odometry, std::string(cause));
  }
}

std::vector<MotionRevision> Chain::finishStages() {
  std::vector<MotionRevision> revisions;
  std::vector<std::string> impossible;
  finishing(Role::Odometry, [&] { return stages_.odometry.finish(revisions, impossible); });
  reportImpossible(-1, impossible);
  finishing(Role::Place, [&] { return stages_.place.finish(); });
  finishing(Role::Cells, [&] { return stages_.cells.finish(); });
  std::erase_if(revisions, [&](const MotionRevision& r) { return r.frame > last_map_.frame; });
  if (localised_) return revisions;
  finishing(Role::Map, [&] { return stages_.map.checkLastPose(); });
  finishing(Role::Map, [&] { return stages_.map.finish(revisions); });
  return revisions;
}

void Chain::finish() {
  const bool had_failed = failed();
  if (unanswered_ >= 0) stages_.map.forgetFrom(unanswered_);
  completeCounters();
  const std::vector<MotionRevision> revisions = finishStages();
  std::vector<record::FinalPose> poses;
  (void)applyPolicy(readTrajectory(poses), -1, Role::Map);
  if (const Status status = listener_.onTrajectory(poses); !status.isOk()) {
    fail(Role::Observer, status);
  }
  MapGraph graph;
  const auto read_graph = [&] { return finalGraph(poses, graph); };
  // After a failure the graph may name a frame without a record. This is not a further failure.
  if (had_failed ? timed(finish_times_ns_, Role::Map, read_graph).isOk()
                 : finishing(Role::Map, read_graph)) {
    countGraph(graph);
  } else {
    if (stopsFor(Role::Map)) return;
    graph = MapGraph();  // the record keeps the graph that was published last
  }
  const Status published = listener_.onFinish(revisions, graph);
  if (!published.isOk()) fail(Role::Observer, published);
}

std::string_view RunCounters::endText() const {
  if (!neverTracked()) {
    const bool dark = lost_at_end && 2 * nearly_black > lost + initialising;
    return dark ? "odometry was lost at the end: most images without tracking are nearly black; if "
                  "their files have 16 bits of which the camera uses fewer, set source.bits, see "
                  "log.txt; otherwise expose them longer"
                : "";
  }
  if (frames == 1) {
    return "no motion in the whole run: it has one frame, and motion is found between two; take "
           "more";
  }
  if (2 * impossible > frames) {
    return "no motion in the whole run: most motions exceed the limits of `checks`, see log.txt; "
           "correct the limits, or the time stamps, the frame rate or the units of the source";
  }
  if (2 * nearly_black > frames) {
    return "no motion in the whole run: the images are nearly black; if their files have 16 bits "
           "of which the camera uses fewer, set source.bits, see log.txt; otherwise expose them "
           "longer";
  }
  if (unmoved > 0) {
    return "no motion in the whole run: odometry answered exactly zero at each frame; if the "
           "camera moved, see `tolman dataset check`, and `tolman plugins validate` for the plugin";
  }
  return "no motion in the whole run; are the images rectified, and left and right not exchanged? "
         "does their calibration fit, are depth images aligned and in the unit that the source "
         "expects, and does the camera move, not only turn? see `tolman dataset check`";
}

}  // namespace tolman::engine
