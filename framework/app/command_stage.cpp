// SPDX-License-Identifier: BSD-3-Clause
// tolman run-stage: the inside of a stage that runs in a process of its own. Not for people.
#include <CLI/CLI.hpp>

#include "app/program.hpp"
#include "app/services.hpp"
#include "isolation/servant.hpp"
#include "record/artefacts.hpp"

namespace tolman::app {

void addStageCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("run-stage", "The inside of an isolated stage")->group("");
  auto descriptors = std::make_shared<std::vector<int>>();
  command->add_option("descriptors", *descriptors)->required()->expected(4);
  command->callback([descriptors] {
    const SteadyClock clock;
    isolation::serve(*descriptors, {clock, [](const auto& directory, const auto& instance) {
                                      return std::make_unique<record::ArtefactFolder>(directory,
                                                                                      instance);
                                    }});
  });
}

}  // namespace tolman::app
