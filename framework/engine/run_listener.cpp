// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run_listener.hpp"

#include <utility>

#include "engine/saved_state.hpp"
#include "record/replay.hpp"

namespace tolman::run {

RunListener::RunListener(record::Recorder& recorder, Assembly& assembly,
                         const record::RunDirectory& directory, RunLog& log, const Clock& clock)
    : recorder_(recorder),
      assembly_(assembly),
      observers_(assembly.observers()),
      directory_(directory),
      log_(log),
      clock_(clock),
      settings_(assembly.system().config.record),
      last_checkpoint_ns_(clock.steadyNs()) {}

template <class Call>
Status RunListener::callObservers(std::int64_t frame, Call&& call) {
  for (Assembly::RunningObserver& observer : observers_) {
    if (!failed_observer_.empty()) break;
    const Status status = call(observer.stage);
    if (status.isOk()) continue;
    const std::string& name = observer.stage.instance().name();
    if (observer.policy == config::FailurePolicy::Stop) {
      failed_observer_ = name;
      return status;
    }
    const auto report = failures_.count(name);
    if (report == pipeline::FailureTally::Report::No) continue;
    const char* last =
        report == pipeline::FailureTally::Report::Last ? "; further ones are not reported" : "";
    onEvent({frame, LogLevel::Warning, name, status.message() + last});
  }
  return Status::ok();
}

Status RunListener::begin(const RunInfo& run) {
  record_status_ = recorder_.begin(run);
  if (!record_status_.isOk()) return record_status_;
  return callObservers(-1, [&](host::ObserverStage& o) { return o.begin(run); });
}

Status RunListener::showRecorded() {
  if (observers_.empty()) return Status::ok();
  if (Status synced = recorder_.sync(); !synced.isOk()) return synced;
  const auto reader = record::RunReader::open(directory_.path());
  if (!reader.isOk()) return reader.status();
  const auto sessions = reader.value()->sessions();
  const auto graph = reader.value()->graph();
  if (!sessions.isOk()) return sessions.status();
  if (!graph.isOk()) return graph.status();
  record::ReplayPosition before;
  if (!sessions.value().empty()) before.frame = sessions.value().back().first_frame - 1;
  const auto replay = record::Replay::open(*reader.value(), before, false);
  if (!replay.isOk()) return replay.status();
  for (record::RecordedFrame recorded;;) {
    const Result<bool> read = replay.value()->next(recorded);
    if (!read.isOk()) return read.status();
    if (!read.value()) return Status::ok();
    if (!recorded.motion || !recorded.place || !recorded.decision || !recorded.map) continue;
    Snapshot snapshot = recorded.snapshot();
    snapshot.cells = &recorded.cells;  // observers get empty arrays rather than none
    if (snapshot.frame->frame == last_recorded_) snapshot.graph = &graph.value();
    const Status shown = callObservers(snapshot.frame->frame,
                                       [&](host::ObserverStage& o) { return o.observe(snapshot); });
    if (!shown.isOk()) return shown;
  }
}

Status RunListener::record(const Snapshot& snapshot) {
  Snapshot recorded = snapshot;
  const StageTimes& times = snapshot.stage_times_ns;
  const std::int64_t frame = snapshot.frame->frame;
  const int every = settings_.arrays_every;
  if (every == 0 || frame % every != 0) recorded.cells = nullptr;
  Status status = recorder_.snapshot(recorded);
  if (status.isOk()) last_recorded_ = frame;
  if (status.isOk() && answers_ != nullptr) {
    status = answers_->add(*snapshot.frame, *snapshot.motion, *snapshot.place);
  }
  for (std::size_t role = 0; role < times.size() && status.isOk(); ++role) {
    if (times[role] > 0) status = recorder_.timing(frame, kRoleNames[role], times[role]);
  }
  return status;
}

std::vector<RunEvent> RunListener::takeEvents() {
  const std::lock_guard lock(events_mutex_);
  return std::exchange(events_, {});
}

Status RunListener::onFrame(const Snapshot& snapshot) {
  if (!record_status_.isOk()) return record_status_;
  record_status_ = record(snapshot);
  if (!record_status_.isOk()) return record_status_;
  if (const auto note = source_notes_.add(*snapshot.frame)) {
    onEvent({snapshot.frame->frame, LogLevel::Warning, assembly_.stageName(Role::Source), *note});
  }
  takeFindings(false);
  const std::vector<RunEvent> events = takeEvents();
  Snapshot observed = snapshot;
  observed.events = &events;
  return callObservers(snapshot.frame->frame,
                       [&](host::ObserverStage& o) { return o.observe(observed); });
}

void RunListener::onEvent(const pipeline::Event& event) {
  // Errors are not shown here: they stop the run and are in the outcome, which the caller shows.
  log_.write(event.level, event.source, event.message, event.level != LogLevel::Error);
  (void)recorder_.event(event.frame, event.level, event.source, event.message);
  if (observers_.empty()) return;
  const std::lock_guard lock(events_mutex_);
  events_.push_back(event);
}

void RunListener::takeFindings(bool at_end) {
  Findings& findings = assembly_.findings();
  const auto found = findings.take();
  if (record_status_.isOk() && !found.empty()) record_status_ = recorder_.findings(found);
  for (const auto& kind : at_end ? findings.takeGrownKinds() : findings.takeNewKinds()) {
    onEvent({kind.first.frame, kind.level(), kind.first.stage, kind.text()});
  }
}

bool RunListener::checkpointDue() {
  if (settings_.state_every == 0) return false;
  const std::int64_t now = clock_.steadyNs();
  if (1e-9 * static_cast<double>(now - last_checkpoint_ns_) < settings_.state_every) return false;
  last_checkpoint_ns_ = now;
  return true;
}

/// Syncs the record before the checkpoint, which must not be newer than the record.
Status RunListener::onCheckpoint(const pipeline::Checkpoint& checkpoint) {
  if (settings_.state_every == 0 || !record_status_.isOk()) return record_status_;
  record_status_ = directory_.stillInPlace();
  if (record_status_.isOk()) record_status_ = recorder_.sync();
  if (record_status_.isOk() && answers_ != nullptr) record_status_ = answers_->flush();
  if (record_status_.isOk()) {
    record_status_ = saveCheckpoint(assembly_, directory_.path(), checkpoint);
  }
  return record_status_;
}

Status RunListener::onTrajectory(const std::vector<pipeline::FramePose>& poses) {
  std::vector<record::FinalPose> rows;
  rows.reserve(poses.size());
  for (const auto& pose : poses) {
    if (pose.frame <= last_recorded_) rows.push_back({pose.frame, pose.T_world_camera});
  }
  if (record_status_.isOk()) record_status_ = recorder_.finalPoses(rows);
  return record_status_;
}

Status RunListener::onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) {
  if (!record_status_.isOk()) return record_status_;
  record_status_ = recorder_.revisions(revisions);
  if (record_status_.isOk()) record_status_ = recorder_.graph(graph);
  if (record_status_.isOk() && answers_ != nullptr) record_status_ = answers_->finish(revisions);
  if (!record_status_.isOk()) return record_status_;
  return callObservers(-1, [&](host::ObserverStage& o) { return o.finish(graph); });
}

}  // namespace tolman::run
