// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_listener.hpp"

#include <utility>

namespace tolman::app {
template <class Call>
Status RunListener::tellObservers(std::int64_t frame, Call&& call) {
  for (Assembly::Observer& observer : observers_) {
    if (!observing_) break;
    const Status status = call(observer.stage);
    if (status.isOk()) continue;
    if (observer.policy == config::FailurePolicy::Stop) {
      observing_ = false;
      return status;
    }
    const std::string& name = observer.stage.instance().name();
    const auto tell = failures_.count(name);
    if (tell == pipeline::FailureTally::Tell::No) continue;
    const char* last = tell == pipeline::FailureTally::Tell::LastTime ? "; more are not told" : "";
    onEvent({frame, LogLevel::Warning, name, status.message() + last});
  }
  return Status::ok();
}

Status RunListener::begin(const RunInfo& run) {
  record_status_ = recorder_.camera(run.source.rig);
  if (!record_status_.isOk()) return record_status_;
  return tellObservers(-1, [&](plugins::ObserverStage& o) { return o.begin(run); });
}

Status RunListener::record(const Snapshot& snapshot) {
  Snapshot told = snapshot;
  const StageTimes& times = snapshot.stage_times_ns;
  const std::int64_t frame = snapshot.frame->frame;
  if (arrays_every_ == 0 || frame % arrays_every_ != 0) told.cells = nullptr;
  Status status = recorder_.snapshot(told);
  if (status.isOk()) last_recorded_ = frame;
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
  const std::vector<RunEvent> events = takeEvents();
  Snapshot told = snapshot;
  told.events = &events;
  return tellObservers(snapshot.frame->frame,
                       [&](plugins::ObserverStage& o) { return o.observe(told); });
}

void RunListener::onEvent(const pipeline::Event& event) {
  // A failure that stops the run is what the program ends with: the terminal hears it then.
  log_.write(event.level, event.source, event.message, event.level != LogLevel::Error);
  (void)recorder_.event(event.frame, event.level, event.source, event.message);
  if (observers_.empty()) return;
  const std::lock_guard lock(events_mutex_);
  events_.push_back(event);
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
  if (!record_status_.isOk()) return record_status_;
  return tellObservers(-1, [&](plugins::ObserverStage& o) { return o.finish(graph); });
}

}  // namespace tolman::app
