// SPDX-License-Identifier: BSD-3-Clause
// Reads run.sqlite of a finished, a running or a killed run; never changes it.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/record_rows.hpp"
#include "evaluation/trajectory.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

/// Counts over all frames of the record. For counts of the map use graph().
struct RunTotals {
  std::int64_t frames = 0;
  std::int64_t templates = 0;       ///< frames with a novel view
  std::int64_t loop_decisions = 0;  ///< frames with the decision close_loop
};

/// Whether the lengths of a tracked motion are in metres (Motion::scale_known).
struct TrackedScale {
  std::int64_t frame = -1;
  bool is_known = true;
};

/// Reads the record as it was when it was opened, even if the run continues; trajectories and graph
/// are therefore computed once and cached. Not thread-safe. open() refuses a
/// record that is not what the run wrote: see verify() (digest.hpp).
class RunReader {
 public:
  static Result<std::unique_ptr<RunReader>> open(const std::filesystem::path& directory);

  /// All records of a kind, by frame or id, nested lists included.
  template <Record R>
  Result<std::vector<R>> records() const {
    return answered(name_, [&] {
      std::vector<R> rows;
      forEachRow<R>(database_, "", [&](const R& row) { rows.push_back(row); });
      return rows;
    });
  }
  /// Calls visit(frame, NamedArray) for each array of the cells, frame by frame.
  template <class Visit>
  Status visitCellArrays(Visit&& visit) const {
    return guarded(name_, [&] {
      forEachRow<RecordedArray>(database_, "WHERE \"source\" = 'cells'",
                                [&](const RecordedArray& row) { visit(row.frame, arrayOf(row)); });
    });
  }
  /// The descriptions of the arrays, in the order of RunInfo::arrays.
  Result<std::vector<ArrayInfo>> arrayInfos() const;

  /// The sessions whose frames are recorded, in order; at least one if there are frames.
  Result<std::vector<RecordedSession>> sessions() const;
  /// One more than the last frame.
  Result<std::int64_t> nextFrame() const;
  /// The last frame that the source gave, even if the pipeline dropped it; -1 for none.
  Result<std::int64_t> lastGivenFrame() const;
  /// The experience of the newest recorded frame; -1 where none is recorded.
  Result<std::int64_t> newestExperience() const;
  /// The motions with their last revisions, composed; each session starts with the identity.
  const Result<evaluation::Trajectory>& odometry() const;
  /// Poses in the finished map. For a killed run: the latest pose of the frame's experience,
  /// composed with the frame's pose relative to it.
  const Result<evaluation::Trajectory>& map() const;
  /// The true poses of the frames that have one.
  Result<evaluation::Trajectory> truth() const;
  const Result<MapGraph>& graph() const;
  Result<RunTotals> totals() const;
  /// Whether the last motion was in metres; true where there is none.
  Result<bool> scaleKnown() const;
  /// Of the last motion before frame `end` that was tracked; none where none was.
  Result<std::optional<TrackedScale>> lastScale(std::int64_t end) const;
  /// Whether the tracked motions from frame `first` on have lengths of both kinds.
  Result<bool> mixesScales(std::int64_t first) const;
  Result<std::map<std::string, std::string>> meta() const;
  /// The run in whose map this one localises; empty for other runs.
  Result<std::string> localisedIn() const;
  /// Durations by stage, ns.
  Result<std::map<std::string, std::vector<std::int64_t>>> timing() const;

  const std::filesystem::path& directory() const { return directory_; }
  const Database& database() const { return database_; }

 private:
  RunReader(std::filesystem::path directory, const std::filesystem::path& file);
  template <class T, class Work>
  const Result<T>& once(std::optional<Result<T>>& kept, Work&& work) const {
    if (!kept) kept = answered(name_, work);
    return *kept;
  }

  std::filesystem::path directory_;
  std::string name_;  // of the file, for messages
  Database database_;
  mutable std::optional<Result<evaluation::Trajectory>> odometry_;
  mutable std::optional<Result<evaluation::Trajectory>> map_;
  mutable std::optional<Result<MapGraph>> graph_;
};

/// Whether the run there has ended and was recorded so that its front end can be replayed.
bool canBeReplayed(const std::filesystem::path& directory);

// Reads a recorded run frame by frame, as the snapshots that its observers received.

/// The rows of one frame. Images are not recorded.
struct RecordedFrame {
  Frame frame;
  std::optional<Motion> motion;  ///< with the points of points_frame
  std::optional<PlaceObservation> place;
  std::optional<Decision> decision;
  std::optional<MapUpdate> map;
  std::vector<NamedArray> cells;  ///< only where they were recorded (record.arrays_every)
  StageTimes stage_times_ns{};
  std::vector<RunEvent> events;  ///< since the previous frame

  /// A snapshot with pointers into this object, without a graph.
  Snapshot snapshot() const;
};

/// The position of a replay. A replay of a reader opened later can start from it.
struct ReplayPosition {
  std::int64_t frame = -1;
  std::int64_t events = 0;  ///< number of those that were given
  std::int64_t points_frame = -1;
  Eigen::Matrix<float, 4, Eigen::Dynamic> points;
};

class Replay {
 public:
  /// `reader` must outlive the replay. `unfinished`: the run is still being written; its newest
  /// frame may be incomplete and is not read.
  static Result<std::unique_ptr<Replay>> open(const RunReader& reader, ReplayPosition position,
                                              bool unfinished);

  /// Fills the next frame; false after the last.
  Result<bool> next(RecordedFrame& recorded);
  const ReplayPosition& position() const { return position_; }

 private:
  Replay(const RunReader& reader, ReplayPosition position, bool unfinished);
  void fill(RecordedFrame& recorded);
  void restorePoints(Motion& motion);

  std::string name_;  ///< of the file, for messages
  ReplayPosition position_;
  bool unfinished_;
  std::int64_t end_;  ///< last frame to read
  RowsOf<Frame> frames_;
  RowsOf<Motion> motions_;
  RowsOf<PlaceObservation> places_;
  RowsOf<Decision> decisions_;
  RowsOf<MapUpdate> maps_;
  RowsOf<RecordedArray> arrays_;              ///< of the cells
  std::map<std::int64_t, StageTimes> times_;  ///< by frame
  std::vector<RunEvent> events_;              ///< from `position` on
  std::size_t next_event_ = 0;
};

}  // namespace tolman::record
