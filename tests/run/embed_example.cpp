// SPDX-License-Identifier: BSD-3-Clause
// A program that runs a configuration without the command line; docs/embed.md shows it.
#include <cstdio>

#include "run/run.hpp"

int main(int, char** argv) {
  using namespace tolman::run;
  const Interrupts interrupts;  // before anything that starts threads
  const SteadyClock clock;
  RunLog log;
  auto checked = checkSystem({.config = argv[1]});
  if (const auto* failure = std::get_if<Failure>(&checked))
    return std::puts(failure->message.c_str());
  Run run(log, clock, interrupts, {.out = argv[2]});
  const Outcome outcome = run.execute(std::get<CheckedSystem>(std::move(checked)));
  if (outcome.failure) return std::puts(outcome.failure->message.c_str());
  std::printf("%ld frames, %.3f m ATE: %s\n", outcome.counters.frames,
              outcome.metrics->map.scores->ate_m.rmse, outcome.directory.c_str());
}
