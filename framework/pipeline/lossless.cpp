// SPDX-License-Identifier: BSD-3-Clause
#include <oneapi/tbb/flow_graph.h>

#include "pipeline/flow.hpp"
#include "pipeline/run.hpp"

namespace tolman::pipeline {
namespace {

/// The next frame as a packet; null at the end, after a failure, or when cancelled.
PacketPtr nextPacket(Chain& chain, const Cancellation& cancellation) {
  if (chain.failed() || cancellation.requested()) return nullptr;
  auto packet = std::make_shared<Packet>();
  Status status;
  {
    const StageTimer timer(packet->times, Role::Source);
    status = chain.stages().source.next(packet->frame);
  }
  if (status.isOk()) {
    chain.admit(*packet);
    return packet;
  }
  if (status.code() != StatusCode::EndOfStream) chain.failInput(status);
  return nullptr;
}

}  // namespace

void runLossless(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation) {
  namespace flow = tbb::flow;
  flow::graph graph;
  flow::input_node<PacketPtr> source(graph, [&](tbb::flow_control& control) {
    PacketPtr packet = nextPacket(chain, cancellation);
    if (!packet) control.stop();
    return packet;
  });
  flow::limiter_node<PacketPtr> limiter(graph, static_cast<std::size_t>(options.queue));
  Flow stages(graph, chain,
              [&](const Packet&) { limiter.decrementer().try_put(flow::continue_msg()); });
  flow::make_edge(source, limiter);
  flow::make_edge(limiter, stages.entry());
  source.activate();
  graph.wait_for_all();
}

}  // namespace tolman::pipeline
