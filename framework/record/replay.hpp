// SPDX-License-Identifier: BSD-3-Clause
// A recorded run once more, frame by frame, as its observers saw it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "record/run_reader.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

/// What the record holds of one frame: no images, and of lists (sensors, revisions) nothing.
struct RecordedFrame {
  Frame frame;
  std::optional<Motion> motion;  ///< with the points of its points_frame
  std::optional<PlaceObservation> place;
  std::optional<Decision> decision;
  std::optional<MapUpdate> map;
  std::vector<NamedArray> cells;  ///< empty at frames without, see record.arrays_every
  StageTimes stage_times_ns{};
  std::vector<RunEvent> events;  ///< since the frame before

  /// Refers to this; without a graph.
  Snapshot snapshot() const;
};

/// A row of timing.
struct TimingRow {
  std::int64_t row = 0;
  std::int64_t frame = 0;
  std::string stage;
  std::int64_t duration_ns = 0;
};

/// How far a replay has come; another one, of a reader opened later, goes on from there.
struct ReplayPosition {
  std::int64_t frame = -1;
  std::int64_t timing_row = 0;
  std::int64_t event_row = 0;
  std::int64_t points_frame = -1;
  Eigen::Matrix<float, 4, Eigen::Dynamic> points;
};

class Replay {
 public:
  /// Of `reader`, which must outlive it. `unfinished`: the run goes on, so its newest frame may be
  /// half written and is left for later.
  static Result<std::unique_ptr<Replay>> open(const RunReader& reader, ReplayPosition position,
                                              bool unfinished);

  /// Fills the next frame; false after the last.
  Result<bool> next(RecordedFrame& recorded);
  const ReplayPosition& position() const { return position_; }

 private:
  /// Rows of a record kind in the order of frames, the next one read ahead.
  template <Record R>
  struct Cursor {
    Cursor(const Database& database, std::int64_t after);
    void advance();
    std::optional<R> take(std::int64_t frame);
    Statement rows;
    std::optional<R> ahead;
  };

  Replay(const RunReader& reader, ReplayPosition position, bool unfinished);
  void fill(RecordedFrame& recorded);
  void restorePoints(Motion& motion);
  void readTime();
  void takeTimes(RecordedFrame& recorded);
  void takeEvents(RecordedFrame& recorded);

  const RunReader& reader_;
  ReplayPosition position_;
  bool unfinished_;
  std::int64_t end_;  ///< of the frames that are shown
  Cursor<Frame> frames_;
  Cursor<Motion> motions_;
  Cursor<PlaceObservation> places_;
  Cursor<Decision> decisions_;
  Cursor<MapUpdate> maps_;
  Statement times_;
  std::optional<TimingRow> time_ahead_;
  Statement events_;
  std::vector<std::pair<std::int64_t, RunEvent>> waiting_events_;
};

}  // namespace tolman::record
