// SPDX-License-Identifier: BSD-3-Clause
// tolman report: figures and one self-contained page about runs; tolman export: result files, also
// of a killed run; tolman schema; tolman view: a run in the browser, finished or running. All of
// them read records.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>

#include "app/options.hpp"
#include "app/program.hpp"
#include "engine/replay_server.hpp"
#include "engine/results.hpp"
#include "engine/services.hpp"
#include "host/child_process.hpp"
#include "record/export.hpp"
#include "record/run_reader.hpp"
#include "record/schema.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

/// Refuses to replace these files, except in the directory of the run that they are about.
void refuseOther(const std::string& run, const fs::path& folder, const std::vector<fs::path>& files,
                 bool replace) {
  std::error_code ignored;
  if (!fs::equivalent(run, folder, ignored)) refuseExisting(files, replace, "--out");
}

struct ReportCommand {
  std::vector<std::string> runs;
  Output out;
  bool images = false;
};

void report(const ReportCommand& command, const Invocation& invocation) {
  const std::string& first = command.runs.front();
  const fs::path folder = command.out.path.empty() ? first : command.out.path;
  if (!command.out.path.empty()) {
    refuseOther(first, folder, {folder / "report.html"}, command.out.replace);
  }
  std::vector<std::unique_ptr<record::RunReader>> readers;
  for (const std::string& run : command.runs) {
    readers.push_back(valueOf(record::RunReader::open(run)));
  }
  const engine::SteadyClock clock;
  std::optional<engine::Interrupts> interrupts;
  engine::ViewsOfRun views;
  if (command.images) {
    interrupts.emplace();
    views = [&](const record::RunReader& run, const std::set<std::int64_t>& frames) {
      engine::RecordedImages images(run.directory(), invocation.plugin_paths, clock, *interrupts);
      auto found = images.views(run, frames);
      if (!images.problem().empty()) std::cerr << "without views: " << images.problem() << "\n";
      return found;
    };
  }
  const auto files = valueOf(engine::writeReport(readers, folder, views));
  if (invocation.json) return printFiles(files, invocation);
  printFiles({folder / "report.html"}, invocation);
  if (invocation.quiet) return;
  std::cout << fmt::format("{} figures in {}\n", files.size() - 1, (folder / "figures").string());
}

struct ExportCommand {
  std::string run;
  Output out;
  std::int64_t session = -1;
  bool nwb = false;
  bool npz = false;

  /// A chosen session has its own folder: results.sha256 has digests of the files in `run`.
  fs::path folder() const {
    if (!out.path.empty()) return out.path;
    return session < 0 ? fs::path(run) : fs::path(run) / ("session-" + std::to_string(session));
  }
};

/// Lets the Python package `tolman` write run.nwb or run.npz (`kind`), and adds it to `written`.
/// Its messages go to stderr, and its exit codes for data and record are those of this program.
void exportByPython(const std::string& kind, const ExportCommand& asked, const char* needs,
                    std::vector<fs::path>& written, Invocation& invocation) {
  const fs::path prefix = fs::read_symlink("/proc/self/exe").parent_path().parent_path();
  const std::string packages =
      (prefix / "python").string() + ":" + (prefix / "lib/python3/dist-packages").string();
  const fs::path file = asked.folder() / ("run." + kind);
  host::ChildProcess python({"/usr/bin/env", "-u", "PYTHONHOME", "-u", "PYTHONINSPECT", "-u",
                             "PYTHONHASHSEED", "PYTHONPATH=" + packages, "/usr/bin/python3", "-m",
                             "tolman." + kind, "--force", "--quiet", asked.run, file.string()},
                            {});
  const host::ProcessEnd end = python.end(std::chrono::hours(24));
  if (end.signal == 0 && end.exit_code == 0) {
    written.push_back(file);
    return;
  }
  const auto code = static_cast<ExitCode>(end.exit_code);
  const bool has_said_why =
      end.signal == 0 && (code == ExitCode::Dataset || code == ExitCode::Record);
  invocation.exit_code =
      printFailure(has_said_why ? code : ExitCode::Record,
                   "no run." + kind + " was written" +
                       (has_said_why ? "" : ": Python " + end.text() + "; it needs " + needs));
}

void exportRun(const ExportCommand& asked, Invocation& invocation) {
  const bool by_python = asked.nwb || asked.npz;
  if (asked.session >= 0 && (by_python || asked.out.path == asked.run)) {
    fail(ExitCode::Usage, "--session writes to a folder of its own, without --nwb and --npz");
  }
  const fs::path folder = asked.folder();
  std::vector<fs::path> files;
  for (const std::string_view name : record::kExportedFiles) files.push_back(folder / name);
  if (asked.nwb) files.push_back(folder / "run.nwb");
  if (asked.npz) files.push_back(folder / "run.npz");
  if (!asked.out.path.empty()) refuseOther(asked.run, folder, files, asked.out.replace);
  const auto reader = valueOf(record::RunReader::open(asked.run));
  std::error_code ignored;
  const bool is_new = fs::create_directories(folder, ignored);
  auto exported = record::exportRun(*reader, folder, asked.session);
  if (!exported.isOk() && is_new) fs::remove(folder, ignored);  // if it is empty
  std::vector<fs::path> written = valueOf(std::move(exported));
  if (asked.nwb) {
    exportByPython("nwb", asked, "python3-tolman and python3-h5py", written, invocation);
  }
  if (asked.npz) {
    exportByPython("npz", asked, "python3-tolman and python3-numpy", written, invocation);
  }
  printFiles(written, invocation);
}

void printAddress(const std::string& url, bool hint, const Invocation& invocation) {
  const int port = std::atoi(url.c_str() + url.rfind(':') + 1);  // "http://127.0.0.1:8080/"
  if (invocation.json) {
    std::cout << nlohmann::ordered_json{{"url", url}, {"port", port}}.dump() << std::endl;
    return;
  }
  if (invocation.quiet) return;
  std::cout << "watch at " << url << "  (Ctrl-C ends)" << std::endl;
  if (!hint) return;
  std::cout << "from another machine: ssh -L " << port << ":localhost:" << port
            << " HOST, then open http://localhost:" << port << "/" << std::endl;
}

void view(const engine::ReplayOptions& options, bool hint, const Invocation& invocation) {
  const engine::Interrupts interrupts;  // before anything that starts threads
  const engine::SteadyClock clock;
  std::unique_ptr<ProgressLine> progress;
  const engine::ReplayListener listener{
      [&](const std::string& url) { printAddress(url, hint, invocation); },
      [&](std::int64_t frames) {
        progress = std::make_unique<ProgressLine>(std::cerr, clock, terminalOf(invocation), frames);
      },
      [&] {
        if (progress) progress->step();
      },
      [&] { progress.reset(); },
      [&](const std::string& text) {
        if (!invocation.quiet) std::cerr << engine::wipedLine() + text + "\n";
      }};
  engine::RunLog log;
  engine::ReplayServer(options, log, clock, interrupts, listener).serve();
}

}  // namespace

void addReportCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("report", "Figures and a page about runs (finished, running or killed)");
  auto options = std::make_shared<ReportCommand>();
  addArgument(command, "run", options->runs, "RUN",
              "Run directories; several are shown side by side");
  options->out.add(command, "FOLDER", "Folder to write to (default: the first run directory)",
                   "Replace the report that the --out folder holds");
  command.add_flag("--images", options->images,
                   "Both views of the first loops; reads the images of the run's source again");
  command.callback([options, &invocation] { report(*options, invocation); });
}

void addExportCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand(
      "export", "Write trajectories and map of a run (finished, running or killed)");
  auto asked = std::make_shared<ExportCommand>();
  addArgument(command, "run", asked->run, "RUN", "Run directory");
  asked->out.add(command, "FOLDER",
                 "Folder to write to (default: the run directory; of a session, session-N in it)",
                 "Replace files in the --out folder");
  command.add_flag("--nwb", asked->nwb,
                   "Also run.nwb: Neurodata Without Borders, with seeded spikes");
  command.add_flag("--npz", asked->npz,
                   "Also run.npz: tables, trajectories, arrays and rate maps for NumPy");
  addOption(command, "--session", asked->session, "N",
            "Session whose trajectories to write, from 0 (default: the run's own)")
      ->check(notNegative);
  command.callback([asked, &invocation] { exportRun(*asked, invocation); });
  app.add_subcommand("schema", "Print the reference of run.sqlite (Markdown)")->callback([] {
    std::cout << record::recordsMarkdown();
  });
}

void addViewCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("view", "Show a run in the browser (finished, running or killed)");
  auto options = std::make_shared<engine::ReplayOptions>();
  auto no_hint = std::make_shared<bool>(false);
  auto no_images = std::make_shared<bool>(false);
  addArgument(command, "run", options->run, "RUN", "Run directory");
  addOption(command, "--port", options->port, "PORT",
            "TCP port (default: 8080 or a free one; 0: any)")
      ->check(CLI::Range(0, 65535));
  addOption(command, "--bind", options->bind, "ADDRESS",
            "Address to listen on (default: 127.0.0.1)");
  command.add_flag("--no-images", *no_images, "Do not read the images of the run's source again");
  command.add_flag("--no-browser-hint", *no_hint, "Print only the address");
  command.callback([options, no_hint, no_images, &invocation] {
    options->plugin_paths = invocation.plugin_paths;
    options->images = !*no_images;
    view(*options, !*no_hint, invocation);
  });
}

}  // namespace tolman::app
