// SPDX-License-Identifier: BSD-3-Clause
// Side effects of a plugin on its process: global state, threads, files, memory; and its cost.
#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

#include "conformance/check.hpp"
#include "conformance/process_state.hpp"
#include "host/kept_state.hpp"

namespace tolman::conformance {

namespace {

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void checkCost(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  resetPeak();
  const double before_mib = memoryMib("VmRSS:");
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
  context.measured("peak memory", std::max(0.0, memoryMib("VmHWM:") - before_mib), "MiB");
}

/// The state at the end equals that before the library was opened. The interpreter of a program is
/// the host's own, and writes the stack at a fault: it is opened first.
void checkGlobals(CheckContext& context) {
  if (!context.manifest().program.empty()) (void)context.plugin();
  constexpr unsigned kSeed = 20240607;
  std::srand(kSeed);
  const int random = std::rand();  // NOLINT: only compared
  std::srand(kSeed);
  const OutputCapture out(STDOUT_FILENO);
  const OutputCapture err(STDERR_FILENO);
  const ProcessState before = processState();
  (void)host::takeRestored();
  const InputSequence sequence = context.sequence();
  const int opencv_threads = openCvThreads();
  context.runOnce(sequence);
  for (const std::string& difference : differences(before, processState()))
    context.error(difference);
  for (const std::string& name : host::takeRestored())
    context.error(name + " was changed; the host restored it");
  if (std::rand() != random) context.error("rand() or srand() of the C library was called");
  if (openCvThreads() != opencv_threads) context.error("cv::setNumThreads() was called");
  if (!out.text().empty()) context.error("wrote to stdout: '" + out.text() + "'");
  if (!err.text().empty()) context.warning("wrote to stderr: '" + err.text() + "'");
}

/// The first instance may create pools and caches that stay; the second must release all that it
/// acquires. oneTBB gets no workers, so every other thread is the plugin's own.
void checkLeaks(CheckContext& context) {
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const InputSequence sequence = shortened(context.sequence(), 8);
  const std::size_t at_first = threadCount(1);
  context.runOnce(sequence);
  const std::size_t before = threadCount(at_first);
  const std::map<int, std::string> files_before = openFiles();
  const auto instance = context.configured(sequence.rig);
  context.require(instance->run(sequence));
  context.require(instance->finish(sequence));
  const std::size_t after_finish = threadCount(before);
  context.require(instance->destroy());
  const std::size_t after = threadCount(before);
  if (after > before) {
    context.error(
        "left a thread running: " + std::to_string(after - before) + " more with each instance",
        "join threads in finish() and in the destructor");
  } else if (after_finish > before) {
    context.error("a thread still runs after finish()", "join threads in finish()");
  } else if (before > at_first) {
    context.note(std::to_string(before - at_first) + " threads of a pool remain");
  }
  for (const auto& [descriptor, target] : openFiles()) {
    if (!files_before.contains(descriptor)) context.error("left a file open: " + target);
  }
}

constexpr std::array kProcessChecks = {
    Check{"globals", 2, kAllRoles,
          "does not change locale, signals, rounding, working directory, environment; writes no "
          "output",
          "use the logger, the random stream and the clock of the context", &checkGlobals},
    Check{"leaks", 2, kAllRoles, "leaves no thread running and no file open",
          "close files and join threads in the destructor at the latest", &checkLeaks},
    Check{"cost", 1, kAllRoles, "time and memory, for information", "", &checkCost},
};

}  // namespace

std::span<const Check> processChecks() { return kProcessChecks; }

std::vector<Check> allChecks() {
  std::vector<Check> all;
  for (const auto& group : {declarationChecks(), lifeChecks(), inputChecks(), processChecks()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace tolman::conformance
