// SPDX-License-Identifier: BSD-3-Clause
// Measures speed and memory: of the source alone, and of the whole chain in lossless mode.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "app/assembly.hpp"
#include "evaluation/metrics.hpp"

namespace tolman::app {

struct BenchOptions {
  std::int64_t frames = -1;  ///< measure so many at most; -1 for all
  int repeats = 3;
  bool source_only = false;
  Audience audience;  ///< of the progress of each pass
};

/// One drive through the data. Nothing is recorded and no observer listens.
struct BenchPass {
  std::int64_t frames = 0;
  double seconds = 0;   ///< source: the sum of its calls; chain: from start to the last frame's end
  double peak_mib = 0;  ///< most memory of the process, plugins and all, during the pass
  std::map<std::string, evaluation::StageTiming> stages;  ///< by role

  double rate() const { return seconds > 0 ? static_cast<double>(frames) / seconds : 0; }
};

struct Bench {
  std::string name;
  std::string source;  ///< as the source describes itself
  std::vector<BenchPass> source_passes;
  std::vector<BenchPass> chain_passes;  ///< empty: source only
  bool interrupted = false;             ///< the passes that are here are whole
};

/// Each pass has stages of its own, fresh from their configuration.
std::variant<Bench, Failure> runBench(const SystemOptions& system, const BenchOptions& options,
                                      RunLog& log, const Cancellation& cancellation);

/// A table; ratios are rates over the rate of the first pass.
std::string benchText(const Bench& bench);
nlohmann::ordered_json benchJson(const Bench& bench);

}  // namespace tolman::app
