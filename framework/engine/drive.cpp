// SPDX-License-Identifier: BSD-3-Clause
#include "engine/drive.hpp"

#include <oneapi/tbb/flow_graph.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include "engine/flow.hpp"

namespace tolman::engine {
namespace {

/// The next frame; null at the end, after a failure, or when cancelled.
FrameRecordsPtr nextFrame(Chain& chain, const Cancellation& cancellation) {
  if (chain.failed() || cancellation.requested()) return nullptr;
  auto records = std::make_shared<FrameRecords>();
  const Status status = chain.readFrame(*records);
  if (status.isOk()) {
    chain.admit(*records);
    return records;
  }
  if (!isEndOfInput(status, cancellation)) chain.failInput(status);
  return nullptr;
}

}  // namespace

int concurrency(int threads) { return threads > 0 ? threads : tbb::info::default_concurrency(); }

bool isEndOfInput(const Status& status, const Cancellation& cancellation) {
  return status.code() == StatusCode::EndOfStream ||
         (status.code() == StatusCode::Cancelled && cancellation.requested());
}

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
  flow::make_edge(source, limiter);
  flow::make_edge(limiter, stages.entry());
  source.activate();
  graph.wait_for_all();
}

DriveResult drive(Chain& chain, const config::PipelineSettings& options, int threads,
                  const Cancellation& cancellation) {
  const int workers = concurrency(threads);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(workers));
  tbb::task_arena arena(workers);
  bool interrupted = false;
  Latency latency;
  arena.execute([&] {
    chain.guarded(Role::Source, [&] {
      if (options.mode == config::PipelineMode::Lossless) {
        runLossless(chain, options, cancellation);
      } else {
        latency = runRealtime(chain, options, cancellation);
      }
    });
    interrupted = cancellation.requested();
    if (interrupted) chain.saveNow();  // before finish(), which changes the state
    chain.finish();  // an observer may block here until cancellation, e.g. to serve a page
  });
  return {chain.failure(), interrupted, chain.counters(), chain.finishTimes(), latency};
}

}  // namespace tolman::engine
