// SPDX-License-Identifier: BSD-3-Clause
#include "app/program.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/build_info.hpp"
#include "app/exit_code.hpp"

namespace tolman::app {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  tolman run configs/kitti.yaml --set source.path=~/kitti/sequences/06\n"
    "  tolman run configs/demo.yaml --view             watch it in the browser\n"
    "  tolman run configs/kitti.yaml --set odometry.plugin=my_odometry --plugin-path ~/mine/build\n"
    "  tolman check configs/kitti.yaml --explain       every value and where it comes from\n"
    "  tolman plugins describe bayesian_attractor      parameters of a plugin\n"
    "  tolman plugins new place my_places              a repository with a plugin that works\n"
    "  tolman plugins validate build/mine.so           does a plugin keep the contract?\n"
    "  tolman dataset check ~/kitti/sequences/06       is the data set sound?\n"
    "  tolman dataset render town.yaml --out town       the frames of any source as a KITTI "
    "folder\n"
    "  tolman bench configs/kitti.yaml --frames 200    how fast is the source, and every stage?\n"
    "  tolman report runs/demo                         figures and a page about a run, or several\n"
    "  tolman view runs/demo                           the same run in the browser; also while it "
    "goes on\n"
    "  tolman plan runs/demo --from 0 --to 40,-120      the fastest way through a map\n"
    "  tolman eval truth.txt estimate.txt --align se3  errors of any TUM or KITTI trajectory\n"
    "\n"
    "Exit codes: 0 ok, 2 usage, 3 configuration, 4 plugin, 5 dataset, 6 tracking lost,\n"
    "  7 plugin failed while running, 8 record (disk), 130 interrupted\n";

}  // namespace

int runProgram(int argc, const char* const* argv) {
  CLI::App app{"Tolman: neurobiologically inspired visual SLAM from swappable plugins."};
  app.set_version_flag("--version", std::string("tolman ") + kVersion + " (" + kRevision + ")");
  app.require_subcommand(1);
  app.footer(kFooter);
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
