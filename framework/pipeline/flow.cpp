// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/flow.hpp"

namespace tolman::pipeline {
namespace flow = tbb::flow;

Flow::Flow(flow::graph& graph, Chain& chain, bool place_needs_motion,
           std::function<void(const Packet&)> on_done)
    : entry_(graph),
      odometry_(graph, flow::serial,
                [&chain](PacketPtr packet) {
                  chain.odometry(*packet);
                  return packet;
                }),
      place_(graph, flow::serial,
             [&chain](PacketPtr packet) {
               chain.place(*packet);
               return packet;
             }),
      join_(graph),
      pair_(graph, flow::serial, [](const Pair& pair) { return std::get<0>(pair); }),
      think_(graph, flow::serial,
             [&chain](PacketPtr packet) {
               chain.think(*packet);
               return packet;
             }),
      tell_(graph, flow::serial, [&chain, done = std::move(on_done)](PacketPtr packet) {
        chain.tell(*packet);
        done(*packet);
        return packet;
      }) {
  connect(place_needs_motion);
}

void Flow::connect(bool place_needs_motion) {
  flow::make_edge(entry_, odometry_);
  if (place_needs_motion) {
    flow::make_edge(odometry_, place_);
    flow::make_edge(place_, think_);
  } else {
    flow::make_edge(entry_, place_);
    flow::make_edge(odometry_, flow::input_port<0>(join_));
    flow::make_edge(place_, flow::input_port<1>(join_));
    flow::make_edge(join_, pair_);
    flow::make_edge(pair_, think_);
  }
  flow::make_edge(think_, tell_);
}

}  // namespace tolman::pipeline
