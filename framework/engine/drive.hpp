// SPDX-License-Identifier: BSD-3-Clause
// Drives all frames of a source through the stages.
#pragma once

#include "config/settings.hpp"
#include "engine/chain.hpp"
#include "engine/latency.hpp"
#include "tolman/context.hpp"

namespace tolman::pipeline {

struct DriveResult {
  std::optional<StageFailure> failure;  ///< what stopped the run early, if anything
  bool interrupted = false;  ///< cancellation ended it early; all frames until then are complete
  RunCounters counters;
  StageTimes finish_times_ns{};  ///< time that finish() of each stage took
  Latency latency{};             ///< of a realtime run
};

/// The number of threads for a setting `threads` (0: all cores).
int concurrency(int threads);

/// Processes all frames and finishes all stages. Stages are finished also after a failure or a
/// cancellation, to keep the results so far. `threads` bounds the parallelism (0: all cores).
DriveResult drive(Chain& chain, const config::PipelineSettings& options, int threads,
                  const Cancellation& cancellation);

/// The two ways to pass frames to the stages; drive() chooses by `options.mode`.
void runLossless(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation);
Latency runRealtime(Chain& chain, const config::PipelineSettings& options,
                    const Cancellation& cancellation);

}  // namespace tolman::pipeline
