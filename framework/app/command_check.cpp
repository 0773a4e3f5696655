// SPDX-License-Identifier: BSD-3-Clause
// tolman check: checks a configuration, without opening its data.
#include <iostream>

#include "app/system_options.hpp"
#include "config/resolved.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

/// A run with `continue: DIR` would be refused only when it begins.
void requireEarlierRun(const std::string& directory) {
  if (directory.empty()) return;
  (void)run::require(record::RunReader::open(directory), run::FailureKind::Continuation);
}

}  // namespace

void addCheckCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("check", "Check a configuration without running it");
  auto options = std::make_shared<SystemOptionsReader>(*command);
  auto explain = std::make_shared<bool>(false);
  command->add_flag("--explain", *explain, "Print every value with its origin");
  command->callback([options, explain, &invocation] {
    run::SystemOptions system = options->read(invocation);
    system.apart = true;
    const auto checked = run::require(run::checkSystem(system));
    requireEarlierRun(checked.config.general.continue_from);
    if (*explain) {
      std::cout << config::explain(checked.config, checked.values);
    } else if (invocation.json) {
      std::cout << R"({"sound": true, "stages": )" << checked.config.stages.size() << "}\n";
    } else if (!invocation.quiet) {
      std::cout << "sound: " << checked.config.stages.size() << " stages\n";
    }
  });
}

}  // namespace tolman::app
