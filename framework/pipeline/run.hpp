// SPDX-License-Identifier: BSD-3-Clause
// Drives a whole run through the stages.
#pragma once

#include "config/settings.hpp"
#include "pipeline/chain.hpp"
#include "tolman/context.hpp"

namespace tolman::pipeline {

struct Outcome {
  Status status;             ///< Ok, or the failure that stopped the run
  bool interrupted = false;  ///< Cancellation ended it early; what was done is complete
  Counters counters;
  StageTimes finish_times_ns{};  ///< what finish() took of each stage
};

/// How many threads `threads` means (0: all cores).
int concurrency(int threads);

/// Processes all frames and finishes all stages; also after a failure or a cancellation, so that
/// what was computed is kept. `threads` bounds the parallelism (0: all cores).
Outcome run(Chain& chain, const config::PipelineSettings& options, int threads,
            const Cancellation& cancellation);

/// The two ways to feed the chain; run() chooses.
void runLossless(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation);
void runRealtime(Chain& chain, const config::PipelineSettings& options,
                 const Cancellation& cancellation);

}  // namespace tolman::pipeline
