// SPDX-License-Identifier: BSD-3-Clause
// tolman bench: how fast is the source, and every stage?
#include <unistd.h>

#include <iostream>

#include "app/bench.hpp"
#include "app/system_options.hpp"

namespace tolman::app {
namespace {

ExitCode bench(const SystemOptions& system, const BenchOptions& options,
               const Invocation& invocation) {
  const Interrupts interrupts;  // before anything that starts threads
  RunLog log(invocation.quiet);
  const auto result = runBench(system, options, log, interrupts);
  if (const auto* failure = std::get_if<Failure>(&result)) {
    std::cerr << failure->message << (failure->message.ends_with('\n') ? "" : "\n");
    return failure->code;
  }
  const Bench& measured = std::get<Bench>(result);
  if (invocation.json) {
    std::cout << benchJson(measured).dump(2) << "\n";
  } else {
    std::cout << benchText(measured);
  }
  return measured.interrupted ? ExitCode::Interrupted : ExitCode::Ok;
}

}  // namespace

void addBenchCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure the speed of a source and of every stage");
  auto reader = std::make_shared<SystemOptionsReader>(*command);
  auto options = std::make_shared<BenchOptions>();
  command->add_option("--frames", options->frames, "Measure so many frames at most")
      ->check(CLI::PositiveNumber);
  command->add_option("--repeat", options->repeats, "Passes of each kind (default: 3)")
      ->check(CLI::Range(1, 1000));
  command->add_flag("--source-only", options->source_only, "Leave the other stages out");
  command->callback([reader, options, &invocation] {
    options->audience = {isatty(STDERR_FILENO) == 1 && !invocation.quiet, invocation.quiet};
    invocation.exit_code = static_cast<int>(bench(reader->read(invocation), *options, invocation));
  });
}

}  // namespace tolman::app
