// SPDX-License-Identifier: BSD-3-Clause
// The stages as a oneTBB flow graph. Each node works on one packet at a time, in the order of
// arrival; but a serial node may hand on its answers out of order (the next body can start before
// the last result is passed on), so a sequencer stands before every node.
#pragma once

#include <oneapi/tbb/flow_graph.h>

#include <functional>
#include <memory>

#include "pipeline/chain.hpp"

namespace tolman::pipeline {

/// Odometry and place recognition side by side (or one after the other, where place recognition
/// needs the motion), then cells and map, then recorder and observers.
class Flow {
 public:
  /// `on_done` is called in order, once for each packet that went in.
  Flow(tbb::flow::graph& graph, Chain& chain, std::function<void(const Packet&)> on_done);

  tbb::flow::receiver<PacketPtr>& entry() { return entry_; }

 private:
  using Node = tbb::flow::function_node<PacketPtr, PacketPtr>;
  using Sequencer = tbb::flow::sequencer_node<PacketPtr>;
  using Pair = std::tuple<PacketPtr, PacketPtr>;

  void connect(bool place_needs_motion);

  Sequencer entry_;
  tbb::flow::broadcast_node<PacketPtr> fork_;
  Node odometry_;
  Sequencer after_odometry_;
  Node place_;
  Sequencer after_place_;
  tbb::flow::join_node<Pair, tbb::flow::queueing> join_;
  tbb::flow::function_node<Pair, PacketPtr> pair_;
  Sequencer before_think_;
  Node think_;
  Sequencer after_think_;
  Node tell_;
};

}  // namespace tolman::pipeline
