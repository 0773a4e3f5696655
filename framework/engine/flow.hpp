// SPDX-License-Identifier: BSD-3-Clause
// The stages as a oneTBB flow graph. Each node processes one frame at a time, in the order of
// arrival. A serial node may still emit its outputs out of order (the next body can start before
// the last result is passed on), so every node has a sequencer before it.
#pragma once

#include <oneapi/tbb/flow_graph.h>

#include <functional>

#include "engine/chain.hpp"

namespace tolman::engine {

/// Odometry and place recognition side by side (or one after the other, where place recognition
/// needs the motion), then cells and map, then recorder and observers.
class Flow {
 public:
  /// `on_done` is called in order, once for each frame that entered.
  Flow(tbb::flow::graph& graph, Chain& chain, std::function<void(const FrameRecords&)> on_done);

  tbb::flow::receiver<FrameRecordsPtr>& entry() { return entry_; }

 private:
  using Node = tbb::flow::function_node<FrameRecordsPtr, FrameRecordsPtr>;
  using Sequencer = tbb::flow::sequencer_node<FrameRecordsPtr>;
  using Pair = std::tuple<FrameRecordsPtr, FrameRecordsPtr>;

  Sequencer entry_;
  tbb::flow::broadcast_node<FrameRecordsPtr> fork_;
  Node odometry_;
  Sequencer after_odometry_;
  Node place_;
  Sequencer after_place_;
  tbb::flow::join_node<Pair, tbb::flow::queueing> join_;
  tbb::flow::function_node<Pair, FrameRecordsPtr> pair_;
  Sequencer before_cells_and_map_;
  Node cells_and_map_;
  Sequencer after_cells_and_map_;
  Node publish_;
};

}  // namespace tolman::engine
