// SPDX-License-Identifier: BSD-3-Clause
// Reads a recorded run frame by frame, as the snapshots that its observers received.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/run_reader.hpp"
#include "tolman/roles.hpp"

namespace tolman::record {

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
