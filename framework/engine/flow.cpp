// SPDX-License-Identifier: BSD-3-Clause
#include "engine/flow.hpp"

namespace tolman::engine {
namespace flow = tbb::flow;

namespace {

constexpr auto kSequenceOf = [](const FrameRecordsPtr& records) { return records->sequence; };

}  // namespace

Flow::Flow(flow::graph& graph, Chain& chain, std::function<void(const FrameRecords&)> on_done)
    : entry_(graph, kSequenceOf),
      fork_(graph),
      odometry_(graph, flow::serial,
                [&chain](FrameRecordsPtr records) {
                  chain.guarded(Role::Odometry, [&] { chain.odometry(*records); });
                  return records;
                }),
      after_odometry_(graph, kSequenceOf),
      place_(graph, flow::serial,
             [&chain](FrameRecordsPtr records) {
               chain.guarded(Role::Place, [&] { chain.place(*records); });
               return records;
             }),
      after_place_(graph, kSequenceOf),
      join_(graph),
      pair_(graph, flow::serial, [](const Pair& pair) { return std::get<0>(pair); }),
      before_cells_and_map_(graph, kSequenceOf),
      cells_and_map_(graph, flow::serial,
                     [&chain](FrameRecordsPtr records) {
                       chain.guarded(Role::Map, [&] { chain.runCellsAndMap(*records); });
                       return records;
                     }),
      after_cells_and_map_(graph, kSequenceOf),
      publish_(graph, flow::serial, [&chain, done = std::move(on_done)](FrameRecordsPtr records) {
        chain.guarded(Role::Observer, [&] { chain.publish(*records); });
        done(*records);
        return records;
      }) {
  flow::make_edge(entry_, fork_);
  flow::make_edge(fork_, odometry_);
  flow::make_edge(odometry_, after_odometry_);
  flow::make_edge(place_, after_place_);
  if (chain.placeNeedsMotion()) {
    flow::make_edge(after_odometry_, place_);
    flow::make_edge(after_place_, before_cells_and_map_);
  } else {
    flow::make_edge(fork_, place_);
    flow::make_edge(after_odometry_, flow::input_port<0>(join_));
    flow::make_edge(after_place_, flow::input_port<1>(join_));
    flow::make_edge(join_, pair_);
    flow::make_edge(pair_, before_cells_and_map_);
  }
  flow::make_edge(before_cells_and_map_, cells_and_map_);
  flow::make_edge(cells_and_map_, after_cells_and_map_);
  flow::make_edge(after_cells_and_map_, publish_);
}

}  // namespace tolman::engine
