// SPDX-License-Identifier: BSD-3-Clause
// tolman export: result files from run.sqlite, also of a killed run; tolman schema.
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string_view>

#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "host/child_process.hpp"
#include "record/export.hpp"
#include "record/output_places.hpp"
#include "record/reference.hpp"
#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

struct ExportCommand {
  std::string run;
  std::string out;
  std::int64_t session = -1;
  bool nwb = false;
  bool npz = false;
  bool replace = false;

  /// Files of a chosen session go to their own folder: results.sha256 has digests of those in
  /// `run`.
  std::filesystem::path folder() const {
    if (!out.empty()) return out;
    return session < 0 ? std::filesystem::path(run)
                       : std::filesystem::path(run) / ("session-" + std::to_string(session));
  }
};

/// Refuses a folder with another run or with files of these names. In the directory of the run
/// itself they are Tolman's own.
void refuseOther(const ExportCommand& command) {
  const std::filesystem::path folder = command.folder();
  std::vector<std::filesystem::path> files;
  files.reserve(record::kExportedFiles.size() + 2);
  for (const std::string_view name : record::kExportedFiles) files.push_back(folder / name);
  if (command.nwb) files.push_back(folder / "run.nwb");
  if (command.npz) files.push_back(folder / "run.npz");
  requireOrEnd(record::refuseFolders(files, "--out"));  // before any is written
  if (command.out.empty()) return;
  requireOrEnd(record::RunDirectory::mayTakeFilesOf(command.run, folder));
  std::error_code ignored;
  if (std::filesystem::equivalent(command.run, folder, ignored)) {
    if (command.session < 0) return;
    throw Ended{ExitCode::Usage,
                "--session would replace the files of the run's own session; leave out --out, or "
                "give another folder"};
  }
  refuseReplacing(files, command.replace, "--out");
}

/// Returns the written files.
std::vector<std::filesystem::path> exportFiles(const record::RunReader& reader,
                                               const ExportCommand& command) {
  std::error_code ignored;
  const std::filesystem::path folder = command.folder();
  const bool is_new = std::filesystem::create_directories(folder, ignored);
  const auto written = record::exportRun(reader, folder, command.session);
  if (!written.isOk() && is_new) std::filesystem::remove(folder, ignored);  // if it is empty
  return valueOrEnd(written);
}

/// Why Python may have ended without a message. Without memory for a package it exits as if that
/// were not there.
std::string causeOf(const isolation::ProcessEnd& end, const std::string& needs) {
  if (end.signal != 0) {
    return "limits of memory and of files (`ulimit -a`) may be too low, or a package is damaged";
  }
  constexpr rlim_t kFewFiles = 32;  // Python with NumPy and SQLite has fewer than 16 open at once
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) == 0 && files.rlim_cur < kFewFiles) {
    return "its open files are limited (`ulimit -n`), or it lacks " + needs;
  }
  rlimit memory{};
  const bool limited = ::getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY;
  return limited ? "its memory is limited (`ulimit -v`), or it lacks " + needs
                 : "it needs " + needs;
}

/// Names of variables for other programs that keep Python from starting, or change what it does.
/// Those that say where its packages are stay.
std::vector<std::string> pythonVariables() {
  std::vector<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text(*entry);
    const std::string_view name = text.substr(0, text.find('='));
    const bool is_place = name == "PYTHONUSERBASE" || name == "PYTHONNOUSERSITE";
    if (name.starts_with("PYTHON") && !is_place) names.emplace_back(name);
  }
  return names;
}

/// Lets the Python package `tolman` write run.nwb or run.npz (`kind`), and adds it to `written`.
/// Its messages go to stderr, and its exit codes for data and record are those of this program.
void exportByPython(const std::string& kind, const ExportCommand& asked, const char* needs,
                    std::vector<std::filesystem::path>& written, Invocation& invocation) {
  std::error_code ignored;
  const auto prefix =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  const std::string folders =
      (prefix / "python").string() + ":" + (prefix / "lib/python3/dist-packages").string();
  const std::filesystem::path file = asked.folder() / ("run." + kind);
  std::vector<std::string> command = {"/usr/bin/env"};
  for (const std::string& name : pythonVariables()) command.insert(command.end(), {"-u", name});
  command.insert(command.end(), {"PYTHONPATH=" + folders, "/usr/bin/python3", "-m",
                                 "tolman." + kind, "--force", "--quiet", asked.run, file.string()});
  isolation::ChildProcess python(command, {});
  const isolation::ProcessEnd end = python.end(std::chrono::hours(24));
  if (end.signal == 0 && end.exit_code == 0) {
    written.push_back(file);
    return;
  }
  constexpr int kData = static_cast<int>(ExitCode::Dataset);
  constexpr int kRecord = static_cast<int>(ExitCode::Record);
  constexpr int kMemory = static_cast<int>(ExitCode::Internal);
  if (end.signal == 0 && (end.exit_code == kData || end.exit_code == kRecord ||
                          end.exit_code == kMemory)) {  // it has said why
    invocation.exit_code =
        printFailure(static_cast<ExitCode>(end.exit_code), "no run." + kind + " was written");
    return;
  }
  invocation.exit_code =
      printFailure(ExitCode::Record, "no run." + kind + " was written: Python " + end.text() +
                                         "; " + causeOf(end, needs));
}

/// Warns if the run has recorded more while Python wrote its files.
void warnOfLaterState(const record::RunReader& first, const std::string& run) {
  if (first.hasEnd()) return;
  const auto now = record::RunReader::open(run);
  if (!now.isOk()) return;  // it could be opened before: other warnings are of damage
  const std::int64_t before = valueOrEnd(first.nextFrame());
  const std::int64_t after = valueOrEnd(now.value()->nextFrame());
  if (after == before) return;
  std::cerr << "warning: " << run << ": the run goes on: trajectories and map are of its first "
            << before << " frames, run.nwb and run.npz of up to " << after
            << "; export again when it has ended\n";
}

}  // namespace

void addExportCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "export", "Write trajectories and map of a run (finished, running or killed)");
  auto asked = std::make_shared<ExportCommand>();
  command->add_option("run", asked->run, "Run directory")->type_name("RUN")->required();
  command
      ->add_option("--out", asked->out,
                   "Folder to write to (default: the run directory; of a session, session-N in it)")
      ->type_name("FOLDER")
      ->check(notEmpty);
  addForce(*command, asked->replace, "Replace files in the --out folder");
  command->add_flag("--nwb", asked->nwb,
                    "Also run.nwb: Neurodata Without Borders, with seeded spikes");
  command->add_flag("--npz", asked->npz,
                    "Also run.npz: tables, trajectories, arrays and rate maps for NumPy");
  command
      ->add_option("--session", asked->session,
                   "Session whose trajectories to write, from 0 (default: the run's own)")
      ->check(notNegative);
  command->callback([asked, &invocation] {
    if (asked->session >= 0 && (asked->nwb || asked->npz)) {
      throw Ended{
          ExitCode::Usage,
          "--nwb and --npz write the run's own session; leave out --session, or export twice"};
    }
    requireRun(asked->run);
    refuseOther(*asked);
    const auto reader = valueOrEnd(record::RunReader::open(asked->run));
    std::vector<std::filesystem::path> written = exportFiles(*reader, *asked);
    if (asked->nwb) {
      exportByPython("nwb", *asked, "python3-tolman and python3-h5py", written, invocation);
    }
    if (asked->npz) {
      exportByPython("npz", *asked, "python3-tolman and python3-numpy", written, invocation);
    }
    printFiles(written, invocation);
    if (asked->nwb || asked->npz) warnOfLaterState(*reader, asked->run);
    warnOfChangedRecord(*reader);
    warnOfRunFiles(asked->run);
  });

  CLI::App* schema = app.add_subcommand("schema", "Print the reference of run.sqlite (Markdown)");
  schema->callback([] { std::cout << record::recordsMarkdown(); });
}

}  // namespace tolman::app
