// SPDX-License-Identifier: BSD-3-Clause
// Measures speed and memory: of the source alone, and of all stages in lossless mode.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/assembly.hpp"
#include "evaluation/metrics.hpp"

namespace tolman::experiment {

/// Callbacks of a caller that shows progress; `frame` may come from any thread.
struct BenchProgress {
  std::function<void(std::int64_t frames)> begin_pass;  ///< frames of the source; -1: unknown
  std::function<void()> frame;
  std::function<void()> end_pass;
};

struct BenchOptions {
  std::int64_t frames = -1;  ///< measure at most this many; -1 for all
  int repeats = 3;
  bool source_only = false;
  BenchProgress progress{[](std::int64_t) {}, [] {}, [] {}};
};

/// One pass over the data. Nothing is recorded and there are no observers.
struct BenchPass {
  std::int64_t frames = 0;
  double seconds = 0;   ///< source: sum of its calls; all stages: until the last frame has ended
  double peak_mib = 0;  ///< peak resident memory of the process, plugins included
  std::map<std::string, evaluation::StageTiming> stages;  ///< by role
  double rectifying_s = 0;  ///< part of `seconds` for rectifying raw images; source passes only

  double rate() const { return seconds > 0 ? static_cast<double>(frames) / seconds : 0; }
};

struct Bench {
  std::string name;
  std::string source;  ///< as the source describes itself
  std::vector<BenchPass> source_passes;
  std::vector<BenchPass> chain_passes;  ///< empty: source only
  bool interrupted = false;             ///< the passes listed are complete
};

/// Each pass creates and configures its stages again. Throws engine::Failure.
Bench runBench(const engine::SystemOptions& system, const BenchOptions& options,
               engine::RunLog& log, const Cancellation& cancellation);

/// A table; ratios are rates over the rate of the first pass.
std::string benchText(const Bench& bench);
nlohmann::ordered_json benchJson(const Bench& bench);

}  // namespace tolman::experiment
