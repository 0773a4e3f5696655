// SPDX-License-Identifier: BSD-3-Clause
// tolman run: a whole run, recorded.
#include "app/exit_guard.hpp"
#include "app/output_files.hpp"
#include "app/summary.hpp"
#include "app/system_options.hpp"
#include "engine/page_observer.hpp"

namespace tolman::app {
namespace {

struct RunCommand {
  std::string out;
  bool replace = false;
  std::string resume;
  bool view = false;
  std::string viewer;  ///< id of the observer that --view adds; empty: the first with a page
};

ExitCode execute(const RunCommand& command, run::SystemOptions options,
                 const Invocation& invocation) {
  const run::Interrupts interrupts;  // before anything that starts threads
  if (command.view) {
    const host::Catalogue catalogue = run::openCatalogue(options.plugin_paths);
    options.observers.push_back(run::require(run::findPageObserver(catalogue, command.viewer)));
  }
  auto checked = run::require(run::checkSystem(options));
  run::RunLog log(invocation.quiet);
  const run::SteadyClock clock;
  run::Run run(log, clock, interrupts,
               {command.out, command.replace, command.resume, invocation.command_line, false,
                [](const run::Outcome& outcome) { return static_cast<int>(exitCode(outcome)); }});
  const ExitGuard guard;
  const run::Outcome outcome = run.execute(std::move(checked));
  return printOutcome(outcome, invocation);
}

}  // namespace

void addRunCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("run", "Run a configuration and record everything");
  auto options = std::make_shared<SystemOptionsReader>(*command);
  auto run = std::make_shared<RunCommand>();
  command->add_option("--out", run->out, "Run directory (default: runs/NAME-TIME)")
      ->type_name("FOLDER")
      ->check(notEmpty);
  addForce(*command, run->replace, "Replace the run that the --out directory holds");
  options->addContinue(*command);
  auto* view = command->add_flag("--view", run->view, "Show the run in the browser");
  command
      ->add_option("--viewer", run->viewer,
                   "Observer that --view adds (default: the first by id that serves a page)")
      ->type_name("OBSERVER")
      ->needs(view);
  command->callback([options, run, &invocation] {
    run->resume = options->resumed();
    invocation.exit_code = execute(*run, options->read(invocation), invocation);
  });
}

}  // namespace tolman::app
