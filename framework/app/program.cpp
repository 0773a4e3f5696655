// SPDX-License-Identifier: BSD-3-Clause
#include "app/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <string_view>

#include "app/build_info.hpp"
#include "app/exit_code.hpp"

namespace tolman::app {
namespace {

struct Example {
  std::string_view command;
  std::string_view says;
};

constexpr std::array kExamples = {
    Example{"tolman run configs/kitti.yaml --set source.path=~/kitti/sequences/06", ""},
    Example{"tolman run configs/demo.yaml --view", "watch it in the browser"},
    Example{"tolman run configs/kitti.yaml --set odometry.plugin=my_odometry --plugin-path "
            "~/mine/build",
            ""},
    Example{"tolman run configs/kitti.yaml --continue runs/monday --out runs/tuesday",
            "go on with a saved map"},
    Example{"tolman check configs/kitti.yaml --explain", "every value and where it comes from"},
    Example{"tolman plugins list", "what is installed"},
    Example{"tolman plugins describe bayesian_attractor", "parameters of a plugin"},
    Example{"tolman plugins doctor build/mine.so", "why is a library not loaded?"},
    Example{"tolman plugins new place my_places", "a repository with a plugin that works"},
    Example{"tolman plugins validate build/mine.so", "does a plugin keep the contract?"},
    Example{"tolman dataset check ~/kitti/sequences/06", "is the data set sound?"},
    Example{"tolman dataset render town.yaml --out town",
            "the frames of any source as a KITTI folder"},
    Example{"tolman bench configs/kitti.yaml --frames 200",
            "how fast is the source, and every stage?"},
    Example{"tolman report runs/demo", "figures and a page about a run, or several"},
    Example{"tolman report runs/demo --grid-unit 12,30", "the firing rate of another grid unit"},
    Example{"tolman view runs/demo", "the same run in the browser; also while it goes on"},
    Example{"tolman plan runs/demo --from 0 --to 40,-120", "the fastest way through a map"},
    Example{"tolman export runs/demo", "trajectories and map of a run that was killed"},
    Example{"tolman eval truth.txt estimate.txt --align se3",
            "errors of any TUM or KITTI trajectory"},
};

constexpr std::string_view kExitCodes =
    "Exit codes: 0 ok, 2 usage, 3 configuration, 4 plugin, 5 dataset, 6 tracking lost,\n"
    "  7 plugin failed while running, 8 record (disk), 9 session, 130 interrupted\n";

/// The examples that begin with `command`; nothing where there are none.
std::string examplesOf(std::string_view command) {
  std::string text;
  for (const Example& example : kExamples) {
    if (!example.command.starts_with(command)) continue;
    text += example.says.empty() ? fmt::format("  {}\n", example.command)
                                 : fmt::format("  {:<48}  {}\n", example.command, example.says);
  }
  return text.empty() ? text : "Examples:\n" + text + "\n";
}

/// Each command teaches itself.
void addExamples(CLI::App& app, const std::string& command) {
  app.footer(examplesOf(command) + std::string(kExitCodes));
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    addExamples(*sub, command + " " + sub->get_name());
  }
}

}  // namespace

int runProgram(int argc, const char* const* argv) {
  CLI::App app{"Tolman: neurobiologically inspired visual SLAM from swappable plugins."};
  app.set_version_flag("--version", std::string("tolman ") + kVersion + " (" + kRevision + ")");
  app.require_subcommand(1);
  Invocation invocation;
  invocation.command_line.assign(argv, argv + argc);
  app.add_option("--plugin-path", invocation.plugin_paths,
                 "Folder or library to search first for plugins (repeatable)");
  app.add_flag("--json", invocation.json, "Machine-readable output on stdout");
  app.add_flag("-q,--quiet", invocation.quiet, "Only errors");
  app.fallthrough();
  addRunCommand(app, invocation);
  addCheckCommand(app, invocation);
  addPluginsCommand(app, invocation);
  addDatasetCommand(app, invocation);
  addBenchCommand(app, invocation);
  addEvalCommand(app, invocation);
  addExportCommand(app, invocation);
  addReportCommand(app, invocation);
  addViewCommand(app, invocation);
  addPlanCommand(app, invocation);
  addStageCommand(app);
  addExamples(app, "tolman");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::Usage);
  } catch (const std::exception& error) {  // a defect of the host, not of what it was given
    std::cerr << "tolman: internal error: " << error.what() << "\n";
    return 70;
  }
  return invocation.exit_code;
}

ExitCode tell(const Failure& failure) {
  std::cerr << failure.message << (failure.message.ends_with('\n') ? "" : "\n");
  return failure.code;
}

}  // namespace tolman::app
