// SPDX-License-Identifier: BSD-3-Clause
// Passes the frames and events of a run to the recorder, the log and the observers.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "engine/chain.hpp"
#include "engine/checked_system.hpp"
#include "record/recorder.hpp"
#include "record/run_directory.hpp"
#include "tolman/context.hpp"

namespace tolman::engine {

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
  Status onTrajectory(const std::vector<record::FinalPose>& poses) override;
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
  std::int64_t trimmed_ns_;          ///< time at which freed memory was returned
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
