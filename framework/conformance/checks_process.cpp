// SPDX-License-Identifier: BSD-3-Clause
// What a plugin does to the process that it is a guest in.
#include <oneapi/tbb/global_control.h>

#include <array>
#include <cstdlib>

#include "conformance/check.hpp"
#include "conformance/lab.hpp"
#include "conformance/process_state.hpp"

namespace tolman::conformance {
namespace {

void wholeLife(Lab& lab, const Stimulus& stimulus) {
  const auto actor = lab.living(stimulus.rig);
  lab.demand(actor->run(stimulus));
  lab.demand(actor->finish(stimulus));
  lab.demand(actor->destroy());
}

/// The C library's random numbers go on where they were.
class RandomWatch {
 public:
  RandomWatch() {
    std::srand(kSeed);
    expected_ = std::rand();  // NOLINT: watched, not used
    std::srand(kSeed);
  }
  bool disturbed() const { return std::rand() != expected_; }  // NOLINT

 private:
  static constexpr unsigned kSeed = 20240607;
  int expected_;
};

/// The state before the library was opened is the one to be found at the end.
void checkGlobals(Lab& lab) {
  const RandomWatch random;
  const OutputTrap output;
  const ProcessState before = processState();
  const Stimulus stimulus = lab.stimulus();
  const int opencv_threads = openCvThreads();
  wholeLife(lab, stimulus);
  for (const std::string& difference : differences(before, processState())) lab.error(difference);
  if (random.disturbed()) lab.error("rand() or srand() of the C library was called");
  if (openCvThreads() != opencv_threads) lab.error("cv::setNumThreads() was called");
  if (!output.out().empty()) lab.error("wrote to stdout: '" + output.out() + "'");
  if (!output.err().empty()) lab.warning("wrote to stderr: '" + output.err() + "'");
}

struct Belongings {
  std::size_t threads = 0;
  std::map<int, std::string> files;
};

Belongings belongings(std::size_t expected_threads) {
  return {threadCount(expected_threads), openFiles()};
}

void compareFiles(const Lab& lab, const std::map<int, std::string>& before,
                  const std::map<int, std::string>& after) {
  for (const auto& [descriptor, target] : after) {
    if (!before.contains(descriptor)) lab.error("left a file open: " + target);
  }
}

/// A first life may make pools and caches that stay; a second one has to leave all as it was.
/// oneTBB gets no workers, so that any other thread is the plugin's own.
void checkLeftovers(Lab& lab) {
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const Stimulus stimulus = shortened(lab.stimulus(), 8);
  const Belongings at_first = belongings(1);
  wholeLife(lab, stimulus);
  const Belongings before = belongings(at_first.threads);
  const auto actor = lab.living(stimulus.rig);
  lab.demand(actor->run(stimulus));
  lab.demand(actor->finish(stimulus));
  const std::size_t after_finish = threadCount(before.threads);
  lab.demand(actor->destroy());
  const Belongings after = belongings(before.threads);
  if (after.threads > before.threads) {
    lab.error("left a thread behind: " + std::to_string(after.threads - before.threads) +
                  " more after each life",
              "join threads in finish() and in the destructor");
  } else if (after_finish > before.threads) {
    lab.error("a thread runs on after finish()", "join threads in finish()");
  } else if (before.threads > at_first.threads) {
    lab.note(std::to_string(before.threads - at_first.threads) + " threads of a pool stay");
  }
  compareFiles(lab, before.files, after.files);
}

void checkMemory(Lab& lab) {
  constexpr int kWarmUp = 3;
  constexpr int kLives = 5;
  constexpr double kTolerated = 16;  // KiB a life
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const Stimulus stimulus = shortened(lab.stimulus(), 8);
  for (int i = 0; i < kWarmUp && lab.spent() < 0.3; ++i) wholeLife(lab, stimulus);
  int lives = 0;
  int grown = 0;
  const std::size_t begin = heapBytes();
  for (std::size_t last = begin; lives < kLives && lab.spent() < 0.8; ++lives) {
    wholeLife(lab, stimulus);
    const std::size_t now = heapBytes();
    if (now > last) ++grown;
    last = now;
  }
  const double kib =
      (static_cast<double>(heapBytes()) - static_cast<double>(begin)) / 1024 / std::max(lives, 1);
  lab.figure("heap growth a life", kib, "KiB");
  if (grown == lives && lives > 1 && kib > kTolerated) {
    lab.warning("each life leaves " + std::to_string(static_cast<int>(kib)) + " KiB on the heap");
  }
}

constexpr std::array kChecks = {
    Check{"globals", 2, kAllRoles,
          "leaves locale, signals, rounding, folder, environment, output alone",
          "use the logger, the random stream and the clock of the context", &checkGlobals},
    Check{"leftovers", 2, kAllRoles, "leaves no thread and no open file behind",
          "close what you open, at the latest in the destructor", &checkLeftovers},
    Check{"memory", 3, kAllRoles, "memory does not grow with every life",
          "run the plugin's own tests under -fsanitize=address", &checkMemory},
};

}  // namespace

std::span<const Check> processChecks() { return kChecks; }

}  // namespace tolman::conformance
