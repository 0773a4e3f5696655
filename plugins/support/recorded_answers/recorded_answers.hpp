// SPDX-License-Identifier: BSD-3-Clause
// Reads what source, odometry and place answered in a run with `record.replay`, frame by frame and
// bit for bit, from its run.sqlite. (-0.0 is read as 0.0, except in poses and matrices.)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/record_rows.hpp"
#include "tolman/roles.hpp"

namespace tolman::recorded_answers {

class RecordedAnswers {
 public:
  /// `run` is a run directory. A run that has not ended is refused.
  Status open(const std::string& run);

  const SourceInfo& source() const { return source_; }
  const std::vector<ArrayInfo>& sensors() const { return sensors_; }
  std::int64_t frames() const { return source_.frames; }
  /// "has 20 of the 51 frames of its source, because its run was interrupted; ..."; empty if the
  /// run finished, or if its source did not know how many would come, as live ones.
  const std::string& part() const { return part_; }

  // Frames can be read in any order. Motion and place are read only if the given frame is the one
  // of the recorded run, otherwise they fail.
  Status read(std::int64_t frame, Frame& answer);
  Status read(const Frame& frame, Motion& answer);
  Status read(const Frame& frame, PlaceObservation& answer);
  /// The revisions that odometry reported after the last frame.
  Status read(std::vector<MotionRevision>& revisions);

 private:
  /// The tables that are read frame by frame, with their prepared statements.
  struct Tables {
    explicit Tables(const std::string& file);
    record::Database database;
    record::RowsOf<Frame> frames;
    record::RowsOf<Motion> motions;
    record::RowsOf<PlaceObservation> places;
    record::RowsOf<record::ExactPoses> exact;
    record::Statement points;  ///< the frame and points of the last motion that has some
  };
  void readRun(const std::string& run);
  void restorePoints(Motion& motion);
  Status isOfRun(const Frame& frame);
  template <Record R>
  Status readRow(record::RowsOf<R> Tables::*rows, std::int64_t frame, R& answer);
  Status damaged(const std::string& what) const;

  std::string file_;
  std::optional<Tables> tables_;
  SourceInfo source_;
  std::string part_;
  std::vector<ArrayInfo> sensors_;
  // Points of a frame are recorded once.
  std::int64_t points_frame_ = -1;
  Eigen::Matrix<float, 4, Eigen::Dynamic> points_;
};

}  // namespace tolman::recorded_answers
