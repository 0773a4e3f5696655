// SPDX-License-Identifier: BSD-3-Clause
#include "engine/drive.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

namespace tolman::pipeline {

int concurrency(int threads) { return threads > 0 ? threads : tbb::info::default_concurrency(); }

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

}  // namespace tolman::pipeline
