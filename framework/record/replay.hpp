// SPDX-License-Identifier: BSD-3-Clause
// Reads a recorded run frame by frame, as the snapshots that its observers received.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/run_reader.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

/// The rows of one frame. Images are not recorded; sensors and revisions are not read.
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
  std::int64_t timing_row = 0;
  std::int64_t event_row = 0;
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
  /// The rows of one kind of record in the order of a key column. It reads one row ahead.
  template <Record R>
  struct Cursor {
    Cursor(const Database& database, const std::string& key_column, std::int64_t after);
    void advance();
    std::optional<R> take(std::int64_t frame);
    Statement rows;
    std::int64_t key = 0;  ///< of `ahead`
    std::optional<R> ahead;
  };

  Replay(const RunReader& reader, ReplayPosition position, bool unfinished);
  void fill(RecordedFrame& recorded);
  void restorePoints(Motion& motion);
  void takeTimes(RecordedFrame& recorded);
  void takeEvents(RecordedFrame& recorded);

  const RunReader& reader_;
  ReplayPosition position_;
  bool unfinished_;
  std::int64_t end_;  ///< last frame to read
  Cursor<Frame> frames_;
  Cursor<Motion> motions_;
  Cursor<PlaceObservation> places_;
  Cursor<Decision> decisions_;
  Cursor<MapUpdate> maps_;
  Cursor<RecordedTiming> times_;
  Cursor<RecordedEvent> events_;
  RowsOf<RecordedArray> arrays_;  ///< of the cells at one frame
};

}  // namespace tolman::record
