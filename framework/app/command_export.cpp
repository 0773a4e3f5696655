// SPDX-License-Identifier: BSD-3-Clause
// tolman export: result files from run.sqlite, also of a killed run; tolman schema.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/program.hpp"
#include "record/export.hpp"
#include "record/reference.hpp"
#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

void exportFiles(const std::string& run, const std::string& out, std::int64_t session,
                 const Invocation& invocation) {
  // Files of another session go to a folder of their own: those of the run have digests.
  std::filesystem::path folder = out.empty() ? run : out;
  if (out.empty() && session >= 0) folder /= "session-" + std::to_string(session);
  if (!out.empty()) requireOrEnd(record::RunDirectory::mayTakeFilesOf(run, folder));
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const auto written = valueOrEnd(record::exportRun(run, folder, session));
  printFiles(written, invocation);
}

}  // namespace

void addExportCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "export", "Write trajectories and map of a run (finished, running or killed)");
  auto run = std::make_shared<std::string>();
  auto out = std::make_shared<std::string>();
  command->add_option("run", *run, "Run directory")->type_name("RUN")->required();
  command
      ->add_option("--out", *out,
                   "Folder to write to (default: the run directory; of a session, session-N in it)")
      ->type_name("FOLDER")
      ->check(notEmpty);
  auto session = std::make_shared<std::int64_t>(-1);
  command
      ->add_option("--session", *session,
                   "Session whose trajectories to write, from 0 (default: the run's own)")
      ->check(CLI::NonNegativeNumber);
  command->callback(
      [run, out, session, &invocation] { exportFiles(*run, *out, *session, invocation); });

  CLI::App* schema = app.add_subcommand("schema", "Print the reference of run.sqlite (Markdown)");
  schema->callback([] { std::cout << record::recordsMarkdown(); });
}

}  // namespace tolman::app
