// SPDX-License-Identifier: BSD-3-Clause
// A frame in the pipeline, with the answers that the stages have given so far.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/checked_odometry.hpp"
#include "engine/checkpoint.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"
#include "tolman/status.hpp"

namespace tolman::pipeline {

struct FrameRecords {
  Frame frame;
  Motion motion;
  PlaceObservation place;
  Decision decision;
  MapUpdate map;
  std::vector<NamedArray> cells;
  MapGraph graph;
  std::size_t sequence = 0;      ///< consecutive number in the order of dispatch
  bool graph_changed = false;    ///< `graph` is published with this frame
  bool leave_out_place = false;  ///< realtime: place recognition is late and skips this frame
  bool answered = false;         ///< all stages have answered; the listener may get it
  Status odometry_status;
  Impossible impossible;
  Status place_status;
  StageTimes times{};
  std::chrono::nanoseconds exposed{};  ///< realtime: on the clock of PacedFeed; likewise the next
  std::chrono::steady_clock::time_point posed;  ///< when the map had answered
  std::unique_ptr<Checkpoint> checkpoint;       ///< null: no checkpoint after this frame

  Snapshot snapshot() const {
    return {&frame, &motion, &place, &decision, &map, &cells, graph_changed ? &graph : nullptr,
            times};
  }
};
using FrameRecordsPtr = std::shared_ptr<FrameRecords>;

/// Adds the lifetime of this object to the wall time of one role.
class StageTimer {
 public:
  StageTimer(StageTimes& times, Role role) : slot_(times[static_cast<std::size_t>(role)]) {}
  ~StageTimer() {
    const auto elapsed = std::chrono::steady_clock::now() - start_;
    slot_ += std::chrono::duration_cast<std::chrono::nanoseconds>(elapsed).count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  std::int64_t& slot_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace tolman::pipeline
