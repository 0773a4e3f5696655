// SPDX-License-Identifier: BSD-3-Clause
// Passes frames and events of a run to the recorder, the log and the observers.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "engine/assembly.hpp"
#include "engine/failure_tally.hpp"
#include "engine/listener.hpp"
#include "engine/source_notes.hpp"
#include "record/answers_file.hpp"
#include "record/recorder.hpp"
#include "record/run_directory.hpp"

namespace tolman::run {

class RunListener : public pipeline::Listener {
 public:
  /// `assembly` must have all stages; checkpoints are written below `directory`.
  RunListener(record::Recorder& recorder, Assembly& assembly, const record::RunDirectory& directory,
              RunLog& log, const Clock& clock);

  Status begin(const RunInfo& run);
  /// Shows the observers of a resumed run the recorded frames of its session, as Observer says.
  Status showRecorded();
  Status onFrame(const Snapshot& snapshot) override;
  void onEvent(const pipeline::Event& event) override;
  /// True every `record.state_every` seconds.
  bool checkpointDue() override;
  Status onCheckpoint(const pipeline::Checkpoint& checkpoint) override;
  Status onTrajectory(const std::vector<pipeline::FramePose>& poses) override;
  Status onFinish(const std::vector<MotionRevision>& revisions, const MapGraph& graph) override;

  /// Records the new findings of the stages, and reports those of a new kind; at the end also how
  /// many more there were.
  void takeFindings(bool at_end);
  /// Also records the answers of the front end in `answers`, which must outlive this object.
  void recordAnswers(record::AnswersFile& answers) { answers_ = &answers; }
  /// For a resumed run: `frame` is the last frame that is recorded already.
  void startAfter(std::int64_t frame) { last_recorded_ = frame; }
  /// One more than the last frame that was recorded.
  std::int64_t nextFrame() const { return last_recorded_ + 1; }
  /// The first failure of the record itself, e.g. a full disk.
  const Status& recordStatus() const { return record_status_; }
  const SourceNotes& sourceNotes() const { return source_notes_; }
  /// Name of the observer that stopped the run; empty when none did.
  const std::string& failedObserver() const { return failed_observer_; }

 private:
  Status record(const Snapshot& snapshot);
  std::vector<RunEvent> takeEvents();
  /// Runs `call` for each observer; failures follow the observer's policy.
  template <class Call>
  Status callObservers(std::int64_t frame, Call&& call);

  record::Recorder& recorder_;
  record::AnswersFile* answers_ = nullptr;
  Assembly& assembly_;
  std::vector<Assembly::RunningObserver>& observers_;
  const record::RunDirectory& directory_;
  RunLog& log_;
  const Clock& clock_;
  config::RecordSettings settings_;
  std::int64_t last_checkpoint_ns_;  ///< time at which the last one was due
  std::int64_t last_recorded_ = -1;  ///< frame
  Status record_status_;
  SourceNotes source_notes_;
  pipeline::FailureTally failures_;  // by observer
  std::mutex events_mutex_;          // they come from any thread
  std::vector<RunEvent> events_;     ///< not yet passed to observers
  std::string failed_observer_;      ///< if set, observers are no longer called; recording goes on
};

}  // namespace tolman::run
