// SPDX-License-Identifier: BSD-3-Clause
// tolman bench: how fast is the source, and every stage? tolman bench odometry: how fast is the
// odometry, measured in decoding its images?
#include <unistd.h>

#include <iostream>

#include "app/bench.hpp"
#include "app/bench_odometry.hpp"
#include "app/system_options.hpp"

namespace tolman::app {
namespace {

/// Measures, then prints what was measured.
template <class Run, class Text, class Json>
ExitCode bench(const Run& run, const Text& text, const Json& json, const Invocation& invocation) {
  const Interrupts interrupts;  // before anything that starts threads
  RunLog log(invocation.quiet);
  const auto result = run(log, interrupts);
  if (const auto* failure = std::get_if<Failure>(&result)) return tell(*failure);
  const auto& measured = std::get<0>(result);
  if (invocation.json) {
    std::cout << json(measured).dump(2) << "\n";
  } else {
    std::cout << text(measured);
  }
  return measured.interrupted ? ExitCode::Interrupted : ExitCode::Ok;
}

void addCounts(CLI::App& command, BenchOptions& options) {
  command.add_option("--frames", options.frames, "Measure so many frames at most")
      ->check(CLI::PositiveNumber);
  command.add_option("--repeat", options.repeats, "Passes of each kind (default: 3)")
      ->check(CLI::Range(1, 1000));
}

Audience audienceOf(const Invocation& invocation) {
  return {isatty(STDERR_FILENO) == 1 && !invocation.quiet, invocation.quiet};
}

void addOdometryCommand(CLI::App& bench_command, Invocation& invocation) {
  CLI::App* command = bench_command.add_subcommand(
      "odometry", "Time of source and odometry over the time to decode the same images alone");
  auto reader = std::make_shared<SystemOptionsReader>(*command);
  auto options = std::make_shared<BenchOptions>();
  addCounts(*command, *options);
  command->callback([reader, options, &invocation] {
    options->audience = audienceOf(invocation);
    const SystemOptions system = reader->read(invocation);
    const auto run = [&](RunLog& log, const Interrupts& interrupts) {
      return runOdometryBench(system, *options, log, interrupts);
    };
    invocation.exit_code =
        static_cast<int>(bench(run, odometryBenchText, odometryBenchJson, invocation));
  });
}

}  // namespace

void addBenchCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure the speed of a source and of every stage");
  auto reader = std::make_shared<SystemOptionsReader>(*command);
  auto options = std::make_shared<BenchOptions>();
  addCounts(*command, *options);
  command->add_flag("--source-only", options->source_only, "Leave the other stages out");
  addOdometryCommand(*command, invocation);
  CLI::Option* config = command->get_option("config")->required(false);
  command->callback([command, config, reader, options, &invocation] {
    if (!command->get_subcommands().empty()) return;  // has answered
    if (config->empty()) throw CLI::RequiredError("config");
    options->audience = audienceOf(invocation);
    const SystemOptions system = reader->read(invocation);
    const auto run = [&](RunLog& log, const Interrupts& interrupts) {
      return runBench(system, *options, log, interrupts);
    };
    invocation.exit_code = static_cast<int>(bench(run, benchText, benchJson, invocation));
  });
}

}  // namespace tolman::app
