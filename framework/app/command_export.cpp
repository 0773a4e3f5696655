// SPDX-License-Identifier: BSD-3-Clause
// tolman export: result files from run.sqlite, also of a killed run; tolman schema.
#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/program.hpp"
#include "config/printable_text.hpp"
#include "isolation/child_process.hpp"
#include "record/export.hpp"
#include "record/reference.hpp"
#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

/// What is exported of a record that was changed after its run, or of a run whose run.json is
/// damaged, is exported, but not silently.
void warnOfDamage(const std::string& run) {
  const auto reader = record::RunReader::open(run);
  const Status status = reader.isOk() ? record::checkRows(*reader.value()) : Status::ok();
  if (!status.isOk()) {
    std::cerr << "warning: " << config::printable(status.message())
              << "; what was exported is of the changed record\n";
  }
  warnOfRunFile(run);
}

void exportFiles(const std::string& run, const std::string& out, std::int64_t session,
                 const Invocation& invocation) {
  // Files of a chosen session go to their own folder: results.sha256 has digests of those in `run`.
  std::filesystem::path folder = out.empty() ? run : out;
  if (out.empty() && session >= 0) folder /= "session-" + std::to_string(session);
  if (!out.empty()) requireOrEnd(record::RunDirectory::mayTakeFilesOf(run, folder));
  std::error_code ignored;
  if (session >= 0 && std::filesystem::equivalent(run, folder, ignored)) {
    throw Ended{ExitCode::Usage,
                "--session would replace the files of the run's own session; leave out --out, or "
                "give another folder"};
  }
  const bool is_new = std::filesystem::create_directories(folder, ignored);
  const auto written = record::exportRun(run, folder, session);
  if (!written.isOk() && is_new) std::filesystem::remove(folder, ignored);  // if it is empty
  printFiles(valueOrEnd(written), invocation);
  warnOfDamage(run);
}

/// Lets the Python package `tolman` write run.nwb or run.npz (`kind`). It prints to the same
/// streams, and its exit codes for data and record are those of this program.
void exportByPython(const std::string& kind, const std::string& run, const std::string& out,
                    const char* needs, Invocation& invocation) {
  std::error_code ignored;
  const auto prefix =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  const std::string folders =
      (prefix / "python").string() + ":" + (prefix / "lib/python3/dist-packages").string();
  std::vector<std::string> command = {"/usr/bin/env", "PYTHONPATH=" + folders, "/usr/bin/python3",
                                      "-m",           "tolman." + kind,        run};
  if (!out.empty()) command.push_back((std::filesystem::path(out) / ("run." + kind)).string());
  isolation::ChildProcess python(command, {});
  const isolation::ProcessEnd end = python.end(std::chrono::hours(24));
  if (end.signal == 0 && end.exit_code == 0) return;
  constexpr int kData = static_cast<int>(ExitCode::Dataset);
  constexpr int kRecord = static_cast<int>(ExitCode::Record);
  if (end.signal == 0 && (end.exit_code == kData || end.exit_code == kRecord)) {  // it has said why
    invocation.exit_code =
        printFailure(static_cast<ExitCode>(end.exit_code), "no run." + kind + " was written");
    return;
  }
  const std::string why =
      end.signal != 0
          ? "; limits of memory and of files (`ulimit -a`) may be too low, or a package is damaged"
          : std::string("; it needs ") + needs;
  invocation.exit_code =
      printFailure(ExitCode::Record, "no run." + kind + " was written: Python " + end.text() + why);
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
  auto nwb = std::make_shared<bool>(false);
  command->add_flag("--nwb", *nwb, "Also run.nwb: Neurodata Without Borders, with seeded spikes");
  auto npz = std::make_shared<bool>(false);
  command->add_flag("--npz", *npz,
                    "Also run.npz: tables, trajectories, arrays and rate maps for NumPy");
  auto session = std::make_shared<std::int64_t>(-1);
  command
      ->add_option("--session", *session,
                   "Session whose trajectories to write, from 0 (default: the run's own)")
      ->check(notNegative);
  command->callback([run, out, session, nwb, npz, &invocation] {
    if (*session >= 0 && (*nwb || *npz)) {
      throw Ended{
          ExitCode::Usage,
          "--nwb and --npz write the run's own session; leave out --session, or export twice"};
    }
    exportFiles(*run, *out, *session, invocation);
    if (*nwb) {
      exportByPython("nwb", *run, *out, "python3-tolman and python3-h5py", invocation);
    }
    if (*npz) {
      exportByPython("npz", *run, *out, "python3-tolman and python3-numpy", invocation);
    }
  });

  CLI::App* schema = app.add_subcommand("schema", "Print the reference of run.sqlite (Markdown)");
  schema->callback([] { std::cout << record::recordsMarkdown(); });
}

}  // namespace tolman::app
