// SPDX-License-Identifier: BSD-3-Clause
// A program that runs a configuration without the command line; docs/embed.md shows it.
#include <cstdio>

#include "engine/run.hpp"

int main(int, char** argv) {
  using namespace tolman::engine;
  const Interrupts interrupts;  // before anything that starts threads
  const SteadyClock clock;
  RunLog log;
  const auto fail = [](const Failure& failure) { return std::puts(failure.message.c_str()), 1; };
  auto checked = checkSystem({.config = argv[1]});
  if (const auto* failure = std::get_if<Failure>(&checked)) return fail(*failure);
  Run run(log, clock, interrupts, {.out = argv[2]});
  const Outcome outcome = run.execute(std::get<CheckedSystem>(std::move(checked)));
  if (outcome.failure) return fail(*outcome.failure);
  std::printf("%ld frames, %s\n", outcome.counters.frames, outcome.directory.c_str());
  if (outcome.metrics && outcome.metrics->map.scores)  // there was a ground truth
    std::printf("ATE of the map: %.3f m\n", outcome.metrics->map.scores->ate_m.rmse);
}
