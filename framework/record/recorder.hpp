// SPDX-License-Identifier: BSD-3-Clause
// Writes run.sqlite during the run. If the process is killed, at most the last second is lost.
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
#include "record/schema.hpp"
#include "tolman/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

/// For Recorder::recordArrays(): every frame of the first kMostArrayFrames, then ever fewer.
inline constexpr int kAutomatic = -1;
inline constexpr std::int64_t kMostArrayFrames = 5'000;

/// The least power of two N so that every N-th frame up to `frame` is at most kMostArrayFrames.
constexpr std::int64_t arrayStep(std::int64_t frame) {
  std::int64_t step = 1;
  while (frame >= kMostArrayFrames * step) step *= 2;
  return step;
}

/// All functions may be called from any thread. After a failure, such as a full disk or a row that
/// violates the schema (a frame recorded twice, a link to a missing experience), every later call
/// returns it, and the record ends with the last commit.
///
/// The points of a motion are stored once per points_frame; later rows with the same points_frame
/// have none. Tables `experience` and `link` have the latest values.
class Recorder {
 public:
  /// Creates run.sqlite in an existing directory that has none.
  static Result<std::unique_ptr<Recorder>> open(const std::filesystem::path& directory);
  /// Opens run.sqlite of an interrupted or killed run. Removes the rows from frame `next_frame` on,
  /// and the tables that a run writes once: begin(), graph() and finalPoses() write them again.
  static Result<std::unique_ptr<Recorder>> reopen(const std::filesystem::path& directory,
                                                  std::int64_t next_frame);
  ~Recorder();  ///< closes, and ignores the status of close()
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Arrays of the cells are recorded every N frames; 0: never. kAutomatic: at every
  /// arrayStep()-th frame; those of earlier frames between are removed as the run grows, so the
  /// record of a run that ended has the same frames as if its length had been known.
  void recordArrays(int every) { arrays_every_ = every; }
  /// From now on also records all bits of poses, so that the run can be replayed. `sensors`: how
  /// many of the descriptions of arrays are those of the source.
  Status recordForReplay(std::size_t sensors);

  /// Must be the first call when this run continues `earlier`. Copies its sessions and the frames
  /// below `frames`, but not its map: the map of this run already contains that. `arrays`: those of
  /// the cells as well.
  Status inherit(const RunReader& earlier, std::int64_t frames, bool arrays = true);
  /// The session that begins now.
  Status session(const RecordedSession& session);
  /// The cameras of the source and the descriptions of the arrays.
  Status begin(const RunInfo& run);
  /// One frame with the results and the times of all stages; members other than `frame` may be
  /// null.
  Status snapshot(const Snapshot& snapshot);
  /// Revisions that odometry returned after the last frame.
  Status revisions(const std::vector<MotionRevision>& revisions);
  Status graph(const MapGraph& graph);
  /// Poses of the frames in the finished map.
  Status finalPoses(const std::vector<FinalPose>& poses);
  Status timing(std::int64_t frame, std::string_view stage, std::int64_t duration_ns);
  Status event(std::int64_t frame, LogLevel level, std::string_view source,
               std::string_view message);
  Status findings(const std::vector<RecordedFinding>& findings);
  Status meta(std::string_view key, std::string_view value);
  /// Commits all rows so far, so that they are kept if the process is killed.
  Status commit();
  /// Also writes them to the disk, so that they survive a loss of power.
  Status sync();
  /// Commits, and merges the write-ahead log into run.sqlite. Later calls fail.
  Status close();

 private:
  Recorder(const std::filesystem::path& file, Database database);
  template <class Work>
  Status write(Work&& work);
  void writeGraph(const MapGraph& graph);
  void writeMotion(const Motion& motion);
  void writeArrays(std::int64_t frame, const std::vector<NamedArray>& arrays);
  void removeArraysBetween();
  void removeFrom(std::int64_t next_frame);
  void commitNow();
  void setMeta(const std::string& key, const std::string& value);
  std::int64_t largest(const std::string& column, const std::string& table);
  void mergeLog();
  void commitRegularly(const std::stop_token& stop);

  std::mutex mutex_;  // guards everything below
  std::string name_;
  Database database_;
  StoreWriter store_;
  Statement meta_, remove_arrays_;
  // Hashes of the rows in the tables, so that only changed rows are written.
  std::vector<std::uint64_t> written_experiences_;
  std::vector<std::uint64_t> written_links_;
  std::int64_t points_frame_ = -1;
  int arrays_every_ = 1;
  bool exact_ = false;
  bool in_transaction_ = false;
  bool closed_ = false;
  Status failure_;
  std::condition_variable_any wake_;
  std::jthread committer_;  // last, because its thread uses the members above
};

}  // namespace tolman::record
