// SPDX-License-Identifier: BSD-3-Clause
#include <oneapi/tbb/flow_graph.h>

#include "engine/drive.hpp"
#include "engine/flow.hpp"
#include "engine/input_end.hpp"

namespace tolman::pipeline {
namespace {

/// The next frame; null at the end, after a failure, or when cancelled.
FrameRecordsPtr nextFrame(Chain& chain, const Cancellation& cancellation) {
  if (chain.failed() || cancellation.requested()) return nullptr;
  auto records = std::make_shared<FrameRecords>();
  Status status;
  {
    const StageTimer timer(records->times, Role::Source);
    const StageActivity::Mark mark(chain.stageActivity(), Role::Source);
    status = chain.stages().source.next(records->frame);
  }
  if (status.isOk()) {
    chain.admit(*records);
    return records;
  }
  if (!isEndOfInput(status, cancellation)) chain.failInput(status);
  return nullptr;
}

}  // namespace

void runLossless(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation) {
  namespace flow = tbb::flow;
  flow::graph graph;
  flow::input_node<FrameRecordsPtr> source(graph, [&](tbb::flow_control& control) {
    FrameRecordsPtr records;
    chain.guarded(Role::Source, [&] { records = nextFrame(chain, cancellation); });
    if (!records) control.stop();
    return records;
  });
  flow::limiter_node<FrameRecordsPtr> limiter(graph, static_cast<std::size_t>(options.queue));
  Flow stages(graph, chain,
              [&](const FrameRecords&) { limiter.decrementer().try_put(flow::continue_msg()); });
  const WaitForGraph at_end(graph);
  flow::make_edge(source, limiter);
  flow::make_edge(limiter, stages.entry());
  source.activate();
  graph.wait_for_all();
}

}  // namespace tolman::pipeline
