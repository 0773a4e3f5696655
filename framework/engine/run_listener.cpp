// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run_listener.hpp"

#include <fmt/format.h>
#include <malloc.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "engine/saved_state.hpp"
#include "record/replay.hpp"

namespace tolman::engine {

namespace {

/// Observers are not watched, because one that serves a page works until the user ends the run.
constexpr std::array kWatched = {Role::Source, Role::Odometry, Role::Place, Role::Cells, Role::Map};

std::int64_t sizeOf(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  return error ? 0 : static_cast<std::int64_t>(size);
}

}  // namespace

std::int64_t diskLeft(const std::filesystem::path& directory) {
  std::error_code error;
  const auto space = std::filesystem::space(directory, error);
  return error || space.capacity == 0 ? -1 : static_cast<std::int64_t>(space.available);
}

std::int64_t diskNeeded(const std::filesystem::path& directory) {
  constexpr std::int64_t kResults = 8 << 20;  // report and figures, of any run
  std::int64_t state = 0;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(directory / "state", ignored)) {
    state += sizeOf(entry.path());
  }
  const std::int64_t trajectories = sizeOf(directory / "run.sqlite") / 8;
  return kResults + sizeOf(directory / "run.sqlite-wal") + 2 * state + trajectories;
}

void Watchdog::start() {
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any wake;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
      look();
      wake.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
    }
  });
}

void Watchdog::look() {
  constexpr int kTrimEvery = 10;
  if (settings_.deadline_s > 0) {
    for (const Role role : kWatched) lookAt(role);
  }
  lookAtDisk();
#ifdef __GLIBC__
  if (++looks_ % kTrimEvery == 0) ::malloc_trim(0);
#endif
}

void Watchdog::lookAt(Role role) {
  std::int64_t& reported = reported_[static_cast<std::size_t>(role)];
  const std::int64_t since = activity_[static_cast<std::size_t>(role)];
  const auto seconds = [&](std::int64_t begin) {
    return 1e-9 * static_cast<double>(clock_.steadyNs() - begin);
  };
  if (reported != 0 && since != reported) {
    settings_.report(LogLevel::Info, enumName(role),
                     fmt::format("answered after at most {:.1f} s", seconds(reported)));
    reported = 0;
  }
  if (since == 0 || reported == since || seconds(since) < settings_.deadline_s) return;
  reported = since;
  settings_.report(LogLevel::Warning, enumName(role),
                   fmt::format("has worked on one call for {:.1f} s; the deadline is {:.3g} s "
                               "(pipeline.stage_deadline). The run waits for it",
                               seconds(since), settings_.deadline_s));
}

void Watchdog::lookAtDisk() {
  const std::int64_t left = settings_.disk_left();
  const std::int64_t needed = settings_.disk_needed();
  if (stopped_ || left < 0 || left >= needed) return;
  stopped_ = true;
  const auto mebibytes = [](std::int64_t bytes) { return static_cast<double>(bytes) / (1 << 20); };
  settings_.stop(
      fmt::format("the disk is nearly full: {:.1f} MiB are left, and the run needs about {:.1f} "
                  "MiB to end well, so it stopped; free some space and go on with `tolman run "
                  "--resume`, or run it again if it has no checkpoint yet",
                  mebibytes(left), mebibytes(needed)));
}

RunListener::RunListener(record::Recorder& recorder, Assembly& assembly,
                         const record::RunDirectory& directory, RunLog& log, const Clock& clock)
    : recorder_(recorder),
      assembly_(assembly),
      observers_(assembly.observers()),
      directory_(directory),
      log_(log),
      clock_(clock),
      settings_(assembly.system().config.record),
      last_checkpoint_ns_(clock.steadyNs()) {
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

Status RunListener::onTrajectory(const std::vector<FramePose>& poses) {
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
  if (!record_status_.isOk()) return record_status_;
  return callObservers(-1, [&](host::ObserverStage& o) { return o.finish(graph); });
}

}  // namespace tolman::engine
