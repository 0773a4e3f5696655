// SPDX-License-Identifier: BSD-3-Clause
// The command line `tolman`.
#pragma once

#include <string>
#include <vector>

#include "app/exit_code.hpp"

namespace CLI {
class App;
}

namespace tolman::app {

/// Runs the program; the result is the exit code of the process.
int runProgram(int argc, const char* const* argv);

/// Tells of a failure on stderr; its code is the command's.
ExitCode tell(const Failure& failure);

/// What commands share.
struct Invocation {
  std::vector<std::string> command_line;
  std::vector<std::string> plugin_paths;
  bool json = false;
  bool quiet = false;
  int exit_code = 0;
};

// Each adds one command to `app`; the command stores its exit code in `invocation`.
void addRunCommand(CLI::App& app, Invocation& invocation);
void addCheckCommand(CLI::App& app, Invocation& invocation);
void addPluginsCommand(CLI::App& app, Invocation& invocation);
void addPluginsNewCommand(CLI::App& plugins, Invocation& invocation);  // below `plugins`
void addValidateCommand(CLI::App& plugins, Invocation& invocation);    // below `plugins`
void addDatasetCommand(CLI::App& app, Invocation& invocation);
void addRenderCommand(CLI::App& dataset, Invocation& invocation);  // below `dataset`
void addBenchCommand(CLI::App& app, Invocation& invocation);
void addEvalCommand(CLI::App& app, Invocation& invocation);
void addPlanCommand(CLI::App& app, Invocation& invocation);
void addReportCommand(CLI::App& app, Invocation& invocation);
void addViewCommand(CLI::App& app, Invocation& invocation);
void addExportCommand(CLI::App& app, Invocation& invocation);
void addStageCommand(CLI::App& app);  // hidden

}  // namespace tolman::app
