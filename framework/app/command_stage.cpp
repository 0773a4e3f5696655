// SPDX-License-Identifier: BSD-3-Clause
// tolman run-stage: the process of an isolated stage. Internal.
#include <CLI/CLI.hpp>

#include "app/program.hpp"
#include "engine/services.hpp"
#include "host/plugin_process.hpp"
#include "record/artefacts.hpp"

namespace tolman::app {

void addStageCommand(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("run-stage", "The process of an isolated stage (internal)")->group("");
  auto descriptors = std::make_shared<std::vector<int>>();
  command->add_option("descriptors", *descriptors)->required()->expected(5);
  command->callback([descriptors] {
    const run::SteadyClock clock;
    isolation::runPluginProcess(
        *descriptors, {clock, [](const auto& directory, const auto& instance) {
                         return std::make_unique<record::ArtefactFolder>(directory, instance);
                       }});
  });
}

}  // namespace tolman::app
