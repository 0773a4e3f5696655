// SPDX-License-Identifier: BSD-3-Clause
// Measures speed and memory: of the source alone, and of all stages in lossless mode.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/assembly.hpp"
#include "evaluation/metrics.hpp"
#include "experiment/tables.hpp"

namespace tolman::experiment {

/// Begins a pass over `frames` frames of the source (-1: unknown), and returns what is to be called
/// after each of them, from any thread, and is destroyed at the end of the pass.
using BenchProgress = std::function<std::function<void()>(std::int64_t frames)>;

struct BenchOptions {
  std::int64_t frames = -1;  ///< measure at most this many; -1 for all
  int repeats = 3;
  bool source_only = false;
  BenchProgress progress = [](std::int64_t) { return [] {}; };
};

/// One pass over the data. Nothing is recorded and there are no observers.
struct BenchPass {
  std::string kind;  ///< "source" alone, or "chain"
  std::int64_t frames = 0;
  double seconds = 0;   ///< source: sum of its calls; all stages: until the last frame has ended
  double peak_mib = 0;  ///< peak resident memory of the process, plugins included
  std::map<std::string, evaluation::StageTiming> stages{};  ///< by role

  double rate() const { return seconds > 0 ? static_cast<double>(frames) / seconds : 0; }
};

struct Bench {
  std::string name;
  std::string source;             ///< as the source describes itself
  std::vector<BenchPass> passes;  ///< those that are complete
  bool interrupted = false;
};

/// Each pass creates and configures its stages again. Throws engine::Failure.
Bench runBench(const engine::SystemOptions& system, const BenchOptions& options,
               engine::RunLog& log, const Cancellation& cancellation);

/// A row for each pass; ratios are rates over the rate of the first pass of the same kind.
Table tableOf(const Bench& bench);

}  // namespace tolman::experiment
