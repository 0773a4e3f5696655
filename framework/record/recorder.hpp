// SPDX-License-Identifier: BSD-3-Clause
// Writes run.sqlite as the run goes, so that a kill at any moment loses at most the last second.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "record/run_reader.hpp"
#include "record/session.hpp"
#include "record/store.hpp"
#include "tolman/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

/// All functions may be called from any thread. Each call is written wholly or not at all. A failed
/// disk is final: every later call returns the first failure. A row that breaks a rule of the
/// schema (a frame told twice, a link to no experience) fails its own call only.
///
/// The motion's points are stored once for each points_frame; later rows with the same one hold
/// none. Experiences and links are stored as last known.
class Recorder {
 public:
  /// Creates run.sqlite in an existing directory that has none.
  static Result<std::unique_ptr<Recorder>> open(const std::filesystem::path& directory);
  ~Recorder();  ///< closes, and drops what close() would say
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Before anything else: copies the sessions of an earlier run with all their frames. Its map is
  /// not copied, for this run's knows it and more.
  Status inherit(const RunReader& earlier);
  /// The session that begins now.
  Status session(const Session& session);
  Status camera(const CameraRig& rig);
  /// All that is known of a frame; `frame` must be there, the rest may be null.
  Status snapshot(const Snapshot& snapshot);
  /// The revisions that odometry owed after the last frame.
  Status revisions(const std::vector<MotionRevision>& revisions);
  Status graph(const MapGraph& graph);
  /// Where the frames were, by the finished map.
  Status finalPoses(const std::vector<FinalPose>& poses);
  Status timing(std::int64_t frame, std::string_view stage, std::int64_t duration_ns);
  Status event(std::int64_t frame, LogLevel level, std::string_view source,
               std::string_view message);
  Status meta(std::string_view key, std::string_view value);
  /// Makes all that was written so far safe from a kill.
  Status commit();
  /// Commits and leaves one plain file; nothing can be written afterwards.
  Status close();

 private:
  explicit Recorder(const std::filesystem::path& file);
  template <class Work>
  Status write(Work&& work);
  void writeGraph(const MapGraph& graph);
  void writeMotion(const Motion& motion);
  void rollBackCall();
  void commitNow();
  void commitRegularly(const std::stop_token& stop);

  std::mutex mutex_;  // guards everything below
  std::string name_;
  Database database_;
  StoreWriter store_;
  Statement meta_;
  MapGraph written_;  // what the tables hold, so that only changes are written
  std::int64_t points_frame_ = -1;
  bool in_transaction_ = false;
  bool closed_ = false;
  Status failure_;
  std::condition_variable_any wake_;
  std::jthread committer_;  // last: it uses the others
};

}  // namespace tolman::record
