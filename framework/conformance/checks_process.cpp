// SPDX-License-Identifier: BSD-3-Clause
// Side effects of a plugin on its process: global state, threads, files, memory; and its cost.
#include <dlfcn.h>
#include <oneapi/tbb/global_control.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <thread>

#include "conformance/check.hpp"

namespace tolman::conformance {
namespace fs = std::filesystem;

namespace {

/// What the host does not restore (KeptState) after a call for a frame, as text by name.
std::map<std::string, std::string> processState() {
  std::error_code error;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  std::map<std::string, std::string> state = {
      {"working directory", fs::current_path(error).string()}, {"umask", std::to_string(mask)}};
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    state["environment variable " + text.substr(0, text.find('='))] = text;
  }
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) != 0) continue;
    state["handler of signal " + std::to_string(number)] =
        std::to_string(reinterpret_cast<std::uintptr_t>(action.sa_handler));
  }
  return state;
}

/// Threads of OpenCV, or -1 when it is not loaded.
int openCvThreads() {
  for (const char* name : {"libopencv_core.so.406", "libopencv_core.so"}) {
    void* library = ::dlopen(name, RTLD_NOW | RTLD_NOLOAD);
    if (library == nullptr) continue;
    const auto function = reinterpret_cast<int (*)()>(::dlsym(library, "_ZN2cv13getNumThreadsEv"));
    return function != nullptr ? function() : -1;
  }
  return -1;
}

/// Number of threads. Waits up to 0.5 s for it to fall to `expected`.
std::size_t threadCount(std::size_t expected) {
  using namespace std::chrono_literals;
  std::size_t count = 0;
  for (int i = 0; i < 50; ++i) {
    const fs::directory_iterator tasks("/proc/self/task");
    count = static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
    if (count <= expected) break;
    std::this_thread::sleep_for(10ms);
  }
  return count;
}

/// The target of each open file descriptor.
std::map<int, std::string> openFiles() {
  std::map<int, std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    const std::string target = fs::read_symlink(entry.path(), error).string();
    const bool is_this_list = target.starts_with("/proc/") && target.ends_with("/fd");
    if (!error && !is_this_list) files[std::stoi(entry.path().filename())] = target;
  }
  return files;
}

/// What this process has written to stdout and stderr.
std::string outputOf(const CheckContext& context) {
  std::cout.flush();
  std::fflush(nullptr);
  std::ifstream file(context.task().folder / kOutputFile);
  return {std::istreambuf_iterator<char>(file), {}};
}

double peakMib() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // KiB
}

double millisecondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
      .count();
}

void checkCost(CheckContext& context) {
  const InputSequence sequence = context.sequence();
  const double before_mib = peakMib();
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
  context.measured("peak memory", peakMib() - before_mib, "MiB");
}

/// The state at the end equals that before the library was opened. The interpreter of a program is
/// the host's own, and writes the stack at a fault: it is opened first.
void checkGlobals(CheckContext& context) {
  if (!context.manifest().program.empty()) (void)context.plugin();
  constexpr unsigned kSeed = 20240607;
  std::srand(kSeed);
  const int random = std::rand();  // NOLINT: only compared
  std::srand(kSeed);
  const std::size_t written = outputOf(context).size();
  const auto before = processState();
  const InputSequence sequence = context.sequence();
  const int opencv_threads = openCvThreads();
  const auto instance = context.configured(sequence.rig);
  context.require(instance->run(sequence));
  context.require(instance->finish(sequence));
  context.require(instance->destroy());
  std::map<std::string, std::string> changed;
  std::ranges::set_symmetric_difference(before, processState(),
                                        std::inserter(changed, changed.end()));
  for (const auto& [name, text] : changed) context.error(name + " was changed");
  std::set<std::string> restored = context.plugin().loaded.changed;
  restored.insert(instance->changed().begin(), instance->changed().end());
  for (const std::string& name : restored)
    context.error(name + " was changed; the host restored it");
  if (std::rand() != random) context.error("rand() or srand() of the C library was called");
  if (openCvThreads() != opencv_threads) context.error("cv::setNumThreads() was called");
  const std::string output = outputOf(context).substr(written, 200);
  if (!output.empty()) context.error("wrote to stdout or stderr: '" + output + "'");
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
