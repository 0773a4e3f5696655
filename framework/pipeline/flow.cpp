// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/flow.hpp"

namespace tolman::pipeline {
namespace flow = tbb::flow;

namespace {

constexpr auto kSequenceOf = [](const PacketPtr& packet) { return packet->sequence; };

}  // namespace

Flow::Flow(flow::graph& graph, Chain& chain, std::function<void(const Packet&)> on_done)
    : entry_(graph, kSequenceOf),
      fork_(graph),
      odometry_(graph, flow::serial,
                [&chain](PacketPtr packet) {
                  chain.odometry(*packet);
                  return packet;
                }),
      after_odometry_(graph, kSequenceOf),
      place_(graph, flow::serial,
             [&chain](PacketPtr packet) {
               chain.place(*packet);
               return packet;
             }),
      after_place_(graph, kSequenceOf),
      join_(graph),
      pair_(graph, flow::serial, [](const Pair& pair) { return std::get<0>(pair); }),
      before_think_(graph, kSequenceOf),
      think_(graph, flow::serial,
             [&chain](PacketPtr packet) {
               chain.think(*packet);
               return packet;
             }),
      after_think_(graph, kSequenceOf),
      tell_(graph, flow::serial, [&chain, done = std::move(on_done)](PacketPtr packet) {
        chain.tell(*packet);
        done(*packet);
        return packet;
      }) {
  connect(chain.placeNeedsMotion());
}

void Flow::connect(bool place_needs_motion) {
  flow::make_edge(entry_, fork_);
  flow::make_edge(fork_, odometry_);
  flow::make_edge(odometry_, after_odometry_);
  flow::make_edge(place_, after_place_);
  if (place_needs_motion) {
    flow::make_edge(after_odometry_, place_);
    flow::make_edge(after_place_, before_think_);
  } else {
    flow::make_edge(fork_, place_);
    flow::make_edge(after_odometry_, flow::input_port<0>(join_));
    flow::make_edge(after_place_, flow::input_port<1>(join_));
    flow::make_edge(join_, pair_);
    flow::make_edge(pair_, before_think_);
  }
  flow::make_edge(before_think_, think_);
  flow::make_edge(think_, after_think_);
  flow::make_edge(after_think_, tell_);
}

}  // namespace tolman::pipeline
