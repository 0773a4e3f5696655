// SPDX-License-Identifier: BSD-3-Clause
// A program that runs a configuration without the command line; docs/embed.md shows it.
#include <cstdio>

#include "engine/run.hpp"

int main(int, char** argv) try {
  using namespace tolman::engine;
  const Interrupts interrupts;  // before anything that starts threads
  const SteadyClock clock;
  RunLog log;
  Run run(log, clock, interrupts, {.out = argv[2]});
  const Outcome outcome = run.execute(checkSystem({.config = argv[1]}));
  if (outcome.failure) throw *outcome.failure;
  std::printf("%ld frames, %s\n", outcome.counters.frames, outcome.directory.c_str());
  if (outcome.metrics && outcome.metrics->map.scores)  // there was a ground truth
    std::printf("ATE of the map: %.3f m\n", outcome.metrics->map.scores->ate_m.rmse);
} catch (const tolman::engine::Failure& failure) {
  std::puts(failure.message.c_str());
  return 1;
}
