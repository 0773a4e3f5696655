// SPDX-License-Identifier: BSD-3-Clause
// What watches a run: the listener, which passes its frames and events to the recorder, the log and
// the observers, and the watchdog.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/chain.hpp"
#include "engine/checked_system.hpp"
#include "record/recorder.hpp"
#include "record/run_directory.hpp"
#include "tolman/context.hpp"

namespace tolman::engine {

/// Bytes that an unprivileged user may still write below `directory`; -1 if not known.
std::int64_t diskLeft(const std::filesystem::path& directory);

/// Bytes that the run in `directory` needs for its end: the log of the record is merged into
/// run.sqlite, a state is saved, and results, figures and report are written.
std::int64_t diskNeeded(const std::filesystem::path& directory);

struct WatchdogSettings {
  double deadline_s = 0;  ///< of one call of a stage; 0: none
  std::function<std::int64_t()> disk_left;
  std::function<std::int64_t()> disk_needed;
  // Called from the watchdog's thread.
  std::function<void(LogLevel, std::string_view source, const std::string& text)> report;
  std::function<void(const std::string& why)> stop;  ///< called at most once
};

/// Reports a stage once when a call takes longer than the deadline, and again when it has answered.
/// Asks the run to stop when the disk has no more than the run needs for its end. Returns freed
/// memory to the system: long-lived data of map and record are between freed image buffers, whose
/// pages glibc keeps, and without this the process grows twice as fast as its data.
class Watchdog {
 public:
  Watchdog(const StageActivity& activity, const Clock& clock, WatchdogSettings settings)
      : activity_(activity), clock_(clock), settings_(std::move(settings)) {}

  /// Makes one check. start() makes one each second.
  void look();
  void start();

 private:
  void lookAt(Role role);
  void lookAtDisk();

  const StageActivity& activity_;
  const Clock& clock_;
  WatchdogSettings settings_;
  std::array<std::int64_t, kRoleNames.size()> reported_{};  ///< StageActivity of the call
  int looks_ = 0;
  bool stopped_ = false;
  std::jthread thread_;  // last, because it uses the members above
};

class RunListener : public Listener {
 public:
  /// `assembly` must have all stages; checkpoints are written below `directory`.
  RunListener(record::Recorder& recorder, Assembly& assembly, const record::RunDirectory& directory,
              RunLog& log, const Clock& clock);

  Status begin(const RunInfo& run);
  /// Shows the observers of a resumed run the recorded frames of its session, as Observer says.
  Status showRecorded();
  Status onFrame(const Snapshot& snapshot) override;
  void onEvent(const Event& event) override;
  /// True every `record.state_every` seconds.
  bool checkpointDue() override;
  Status onCheckpoint(const Checkpoint& checkpoint) override;
  Status onTrajectory(const std::vector<FramePose>& poses) override;
  Status onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) override;

  /// Records the new findings of the stages, and reports those of a new kind.
  void takeFindings(bool at_end);
  /// At the end: the same, and how many findings and warnings of the same kind came after those
  /// that were shown.
  void reportRepeated();
  /// For a resumed run: `frame` is the last frame that is recorded already.
  void startAfter(std::int64_t frame) { last_recorded_ = repeated_ = frame; }
  /// One more than the last frame that was recorded.
  std::int64_t nextFrame() const { return last_recorded_ + 1; }
  /// The first failure of the record itself, e.g. a full disk.
  const Status& recordStatus() const { return record_status_; }
  /// Mean time between two recorded frames, s; 0 for fewer than two.
  double meanStep() const {
    return frames_ < 2 ? 0 : 1e-9 * static_cast<double>(last_ns_ - first_ns_) / (frames_ - 1);
  }
  /// Name of the observer that stopped the run; empty when none did.
  std::string failedStage() const override { return failed_observer_; }

 private:
  /// Runs `call` for each observer; failures follow the observer's policy.
  template <class Call>
  Status callObservers(std::int64_t frame, Call&& call);

  record::Recorder& recorder_;
  Assembly& assembly_;
  std::vector<Assembly::RunningObserver>& observers_;
  const record::RunDirectory& directory_;
  RunLog& log_;
  const Clock& clock_;
  config::RecordSettings settings_;
  std::int64_t last_checkpoint_ns_;  ///< time at which the last one was due
  std::int64_t last_recorded_ = -1;  ///< frame
  std::int64_t repeated_ = -1;       ///< the last frame that a resumed run repeats
  Status record_status_;
  int frames_ = 0;
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::mutex events_mutex_;       // they come from any thread
  std::vector<RunEvent> events_;  ///< not yet passed to observers
  struct Repeated {
    RunEvent first;
    int count = 0;
    std::string frames{};  ///< of the next few, ", "-separated
  };
  std::map<std::string, Repeated> kinds_;  ///< of events, by source and text without numbers
  std::string failed_observer_;  ///< if set, observers are no longer called; recording goes on
};

}  // namespace tolman::engine
