// SPDX-License-Identifier: BSD-3-Clause
// Time and memory: reported without a limit.
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

#include "conformance/check.hpp"
#include "host/process_state.hpp"

namespace tolman::conformance {

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void checkCost(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  resetPeakResident();
  const double before_mib = residentMib();
  auto begin = std::chrono::steady_clock::now();
  const auto instance = context.configured(sequence.rig);
  context.measured("configure", millisecondsSince(begin), "ms");
  std::vector<double> frames_ms;
  for (const FrameInput& input : sequence.inputs) {
    begin = std::chrono::steady_clock::now();
    const Status status = instance->process(input);
    if (status.code() == StatusCode::EndOfStream) break;
    context.require(status);
    frames_ms.push_back(millisecondsSince(begin));
  }
  context.require(instance->finish(sequence));
  if (frames_ms.empty()) context.skip("there are no frames");
  std::sort(frames_ms.begin(), frames_ms.end());
  context.measured("frame, median", frames_ms[frames_ms.size() / 2], "ms");
  context.measured("frame, slowest", frames_ms.back(), "ms");
  context.measured("peak memory", std::max(0.0, peakResidentMib() - before_mib), "MiB");
}

constexpr std::array kCostChecks = {
    Check{"cost", 1, kAllRoles, "time and memory, for information", "", &checkCost},
};

}  // namespace

std::span<const Check> costChecks() { return kCostChecks; }

std::vector<Check> allChecks() {
  std::vector<Check> all;
  for (const auto& group : {declarationChecks(), lifeChecks(), inputChecks(), parameterChecks(),
                            repeatChecks(), stateChecks(), processChecks(), costChecks()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

// Side effects of a plugin on its process: global state, threads, files, memory.

namespace {

/// Detects calls of rand() and srand().
class RandProbe {
 public:
  RandProbe() {
    std::srand(kSeed);
    expected_ = std::rand();  // NOLINT: only compared
    std::srand(kSeed);
  }
  bool changed() const { return std::rand() != expected_; }  // NOLINT

 private:
  static constexpr unsigned kSeed = 20240607;
  int expected_;
};

/// The state at the end equals that before the library was opened.
void checkGlobals(CheckContext& context) {
  const RandProbe random;
  const OutputCapture output;
  const ProcessState before = processState();
  const InputSequence sequence = context.sequence();
  const int opencv_threads = openCvThreads();
  context.runOnce(sequence);
  for (const std::string& difference : differences(before, processState()))
    context.error(difference);
  if (random.changed()) context.error("rand() or srand() of the C library was called");
  if (openCvThreads() != opencv_threads) context.error("cv::setNumThreads() was called");
  if (!output.out().empty()) context.error("wrote to stdout: '" + output.out() + "'");
  if (!output.err().empty()) context.warning("wrote to stderr: '" + output.err() + "'");
}

struct Resources {
  std::size_t threads = 0;
  std::map<int, std::string> files;
};

Resources resources(std::size_t expected_threads) {
  return {threadCount(expected_threads), openFiles()};
}

void compareFiles(const CheckContext& context, const std::map<int, std::string>& before,
                  const std::map<int, std::string>& after) {
  for (const auto& [descriptor, target] : after) {
    if (!before.contains(descriptor)) context.error("left a file open: " + target);
  }
}

/// The first instance may create pools and caches that stay; the second must release all that it
/// acquires. oneTBB gets no workers, so every other thread is the plugin's own.
void checkLeaks(CheckContext& context) {
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const InputSequence sequence = shortened(context.sequence(), 8);
  const Resources at_first = resources(1);
  context.runOnce(sequence);
  const Resources before = resources(at_first.threads);
  const auto instance = context.configured(sequence.rig);
  context.require(instance->run(sequence));
  context.require(instance->finish(sequence));
  const std::size_t after_finish = threadCount(before.threads);
  context.require(instance->destroy());
  const Resources after = resources(before.threads);
  if (after.threads > before.threads) {
    context.error("left a thread running: " + std::to_string(after.threads - before.threads) +
                      " more with each instance",
                  "join threads in finish() and in the destructor");
  } else if (after_finish > before.threads) {
    context.error("a thread still runs after finish()", "join threads in finish()");
  } else if (before.threads > at_first.threads) {
    context.note(std::to_string(before.threads - at_first.threads) + " threads of a pool remain");
  }
  compareFiles(context, before.files, after.files);
}

void checkMemory(CheckContext& context) {
  constexpr int kWarmUp = 3;
  constexpr int kInstances = 5;
  constexpr double kTolerated = 16;  // KiB per instance
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const InputSequence sequence = shortened(context.sequence(), 8);
  for (int i = 0; i < kWarmUp && context.timeUsed() < 0.3; ++i) context.runOnce(sequence);
  int instances = 0;
  int grown = 0;
  const std::size_t begin = heapBytes();
  for (std::size_t last = begin; instances < kInstances && context.timeUsed() < 0.8; ++instances) {
    context.runOnce(sequence);
    const std::size_t now = heapBytes();
    if (now > last) ++grown;
    last = now;
  }
  const double kib = (static_cast<double>(heapBytes()) - static_cast<double>(begin)) / 1024 /
                     std::max(instances, 1);
  context.measured("heap growth per instance", kib, "KiB");
  if (grown == instances && instances > 1 && kib > kTolerated) {
    context.warning("each instance leaves " + std::to_string(static_cast<int>(kib)) +
                    " KiB on the heap");
  }
}

constexpr std::array kProcessChecks = {
    Check{"globals", 2, kAllRoles,
          "does not change locale, signals, rounding, working directory, environment; writes no "
          "output",
          "use the logger, the random stream and the clock of the context", &checkGlobals},
    Check{"leaks", 2, kAllRoles, "leaves no thread running and no file open",
          "close files and join threads in the destructor at the latest", &checkLeaks},
    Check{"memory", 3, kAllRoles, "memory does not grow with each instance",
          "run the plugin's own tests under -fsanitize=address", &checkMemory},
};

}  // namespace

std::span<const Check> processChecks() { return kProcessChecks; }

}  // namespace tolman::conformance
