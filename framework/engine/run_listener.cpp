// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run_listener.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <mutex>
#include <utility>

#include "engine/saved_state.hpp"
#include "record/run_reader.hpp"

namespace tolman::engine {

namespace {

/// Returns freed memory to the system: long-lived data of map and record are between freed image
/// buffers, whose pages glibc keeps, and without this the process grows twice as fast as its data.
void returnMemory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace

RunListener::RunListener(record::Recorder& recorder, Assembly& assembly,
                         const record::RunDirectory& directory, RunLog& log, const Clock& clock)
    : recorder_(recorder),
      assembly_(assembly),
      observers_(assembly.observers()),
      directory_(directory),
      log_(log),
      clock_(clock),
      settings_(assembly.system().config.record),
      last_checkpoint_ns_(clock.steadyNs()),
      trimmed_ns_(last_checkpoint_ns_) {
  recorder_.recordArrays(settings_.arrays_every);
}

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
    onEvent({frame, LogLevel::Warning, name, status.message()});
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
  if (!sessions.isOk() || !graph.isOk())
    return sessions.isOk() ? graph.status() : sessions.status();
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

Status RunListener::onFrame(const Snapshot& snapshot) {
  constexpr std::int64_t kTrimEvery = 10'000'000'000;  // ns
  if (const std::int64_t now = clock_.steadyNs(); now - trimmed_ns_ >= kTrimEvery) {
    returnMemory();
    trimmed_ns_ = now;
  }
  if (!record_status_.isOk()) return record_status_;
  record_status_ = recorder_.snapshot(snapshot);
  if (!record_status_.isOk()) return record_status_;
  last_recorded_ = snapshot.frame->frame;
  last_ns_ = snapshot.frame->stamp_ns;
  if (frames_++ == 0) first_ns_ = last_ns_;
  takeFindings(false);
  std::unique_lock lock(events_mutex_);
  const std::vector<RunEvent> events = std::exchange(events_, {});
  lock.unlock();
  Snapshot observed = snapshot;
  observed.events = &events;
  return callObservers(snapshot.frame->frame,
                       [&](host::ObserverStage& o) { return o.observe(observed); });
}

/// The terminal shows events of the same kind once. Errors are not shown here: they stop the run
/// and are in the outcome, which the caller shows.
void RunListener::onEvent(const Event& event) {
  const std::lock_guard lock(events_mutex_);
  Repeated& kind = kinds_[event.source + ": " + withoutNumbers(event.message)];
  constexpr int kNamed = 8;  // frames that the repetition names
  if (kind.count++ == 0) kind.first = event;
  if (kind.count > 1 && kind.count <= kNamed + 1) {
    kind.frames += fmt::format("{}{}", kind.frames.empty() ? "" : ", ", event.frame);
  } else if (kind.count == kNamed + 2) {
    kind.frames += ", ...";
  }
  const bool is_shown = event.level != LogLevel::Error && kind.count == 1;
  log_.write(event.level, event.source, event.message, is_shown);
  (void)recorder_.event(event.frame, event.level, event.source, event.message);
  if (!observers_.empty()) events_.push_back(event);
}

void RunListener::takeFindings(bool at_end) {
  Findings& findings = assembly_.findings();
  auto found = findings.take(at_end);
  std::erase_if(found, [&](const auto& finding) {  // those are in the record
    return finding.frame >= 0 && finding.frame <= repeated_;
  });
  if (record_status_.isOk() && !found.empty()) record_status_ = recorder_.findings(found);
  for (const auto& kind : findings.takeNewKinds()) {
    onEvent({kind.first.frame, kind.level(), kind.first.stage, kind.text()});
  }
}

void RunListener::reportRepeated() {
  takeFindings(true);
  for (const auto& kind : assembly_.findings().takeGrownKinds()) {
    log_.write(kind.level(), kind.first.stage, kind.text());
  }
  const std::lock_guard lock(events_mutex_);
  for (const auto& [text, kind] : kinds_) {
    if (kind.count == 1 || kind.first.level != LogLevel::Warning) continue;
    log_.write(LogLevel::Warning, kind.first.source,
               fmt::format("{} more as this one, at frames {}: {}", kind.count - 1, kind.frames,
                           kind.first.message));
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
Status RunListener::onCheckpoint(const Checkpoint& checkpoint) {
  if (settings_.state_every == 0 || !record_status_.isOk()) return record_status_;
  record_status_ = directory_.stillInPlace();
  if (record_status_.isOk()) record_status_ = recorder_.sync();
  if (record_status_.isOk()) {
    record_status_ = saveCheckpoint(assembly_, directory_.path(), checkpoint);
  }
  return record_status_;
}

Status RunListener::onTrajectory(const std::vector<record::FinalPose>& poses) {
  std::vector<record::FinalPose> rows = poses;
  std::erase_if(rows, [&](const auto& pose) { return pose.frame > last_recorded_; });
  if (record_status_.isOk()) record_status_ = recorder_.finalPoses(rows);
  return record_status_;
}

Status RunListener::onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) {
  if (!record_status_.isOk()) return record_status_;
  record_status_ = recorder_.revisions(revisions);
  if (record_status_.isOk()) record_status_ = recorder_.graph(graph);
  if (!record_status_.isOk()) return record_status_;
  return callObservers(-1, [&](host::ObserverStage& o) { return o.finish(graph); });
}

}  // namespace tolman::engine
