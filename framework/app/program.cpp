// SPDX-License-Identifier: BSD-3-Clause
#include "app/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <iostream>
#include <new>

#include "app/options.hpp"
#include "config/json_text.hpp"
#include "config/text.hpp"
#include "engine/build_info.hpp"
#include "engine/run.hpp"
#include "engine/services.hpp"
#include "host/plugin_process.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {

namespace {

/// A closed pipe and a full disk are errors of the writes, not the end of the process. Closed
/// standard streams, whose numbers the next opened files would take, are opened again.
void prepareStreams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  int descriptor = 0;
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::open("/dev/null", O_RDONLY);
  if (descriptor >= 0) ::close(descriptor);
}

/// Saved states and tables of whole runs get their own pages, which return to the system when they
/// are freed. By default glibc raises this limit to the largest buffer freed so far, and long-lived
/// blocks between such buffers then double the memory growth of a run. Images are smaller: their
/// own pages would cost 5 ms a frame. Freed memory at the end of the heap is kept for the next
/// frame; the listener of the run returns it.
void limitFragmentation() {
#ifdef __GLIBC__
  constexpr int kLargeBuffer = 4 << 20;  // bytes
  constexpr int kMaxKept = 256 << 20;    // bytes
  ::mallopt(M_MMAP_THRESHOLD, kLargeBuffer);
  ::mallopt(M_TRIM_THRESHOLD, kMaxKept);
#endif
}

struct Example {
  std::string_view command;
  std::string_view purpose;
};

/// The help of each command ends with those that begin with it.
constexpr std::array kExamples = {
    Example{"tolman run demo --out runs/demo", "a block of the built-in town"},
    Example{"tolman run ~/recording --view", "your own recording, watched in the browser"},
    Example{"tolman run configs/kitti.yaml --set source.path=~/kitti/sequences/06", "a data set"},
    Example{"tolman run configs/kitti.yaml --continue runs/monday", "continue a saved map"},
    Example{"tolman run configs/kitti.yaml --localise runs/monday", "where in that saved map?"},
    Example{"tolman check configs/kitti.yaml --explain", "every value and where it comes from"},
    Example{"tolman init ~/recording --out mine.yaml", "a configuration for your own recording"},
    Example{"tolman try ~/recording --out tried", "which modules are best on it"},
    Example{"tolman plugins describe bayesian_attractor", "parameters of a plugin"},
    Example{"tolman plugins doctor build/mine.so", "why is a library not loaded?"},
    Example{"tolman plugins new place my_places", "a repository with a plugin that works"},
    Example{"tolman plugins new cells mine --python", "one file in Python that works"},
    Example{"tolman plugins validate build/mine.so", "does a plugin satisfy the contract?"},
    Example{"tolman dataset check ~/kitti/sequences/06", "is the data set sound?"},
    Example{"tolman dataset render town.yaml --out town", "any source as a KITTI folder"},
    Example{"tolman bench configs/kitti.yaml --frames 200", "how fast is every stage?"},
    Example{"tolman report runs/demo", "figures and a page about a run, or several"},
    Example{"tolman view runs/demo", "a run in the browser; also while it is running"},
    Example{"tolman plan runs/demo --from 0 --to 40,-120", "the fastest way through a map"},
    Example{"tolman sweep study.yaml --dry-run", "are all points right, and how many are to do?"},
    Example{"tolman sweep study.yaml --jobs 4", "run what is not done yet"},
    Example{"tolman compare sweeps/study --by cells.period", "a table with intervals"},
    Example{"tolman rerun runs/demo --verify", "does it still give the same bytes?"},
    Example{"tolman export runs/demo", "trajectories and map of a run that was killed"},
    Example{"tolman eval truth.txt estimate.txt", "errors of any TUM or KITTI trajectory"},
};
constexpr const char* kExitCodes =
    "With every command: --json, -q or --quiet, --plugin-path PATH (`tolman --help`).\n"
    "Exit codes: 0 ok, 2 usage, 3 configuration, 4 plugin, 5 dataset, 6 tracking lost,\n"
    "  7 plugin failed while running, 8 record (disk) or output, 9 session,\n"
    "  70 internal error or out of memory, 130 interrupted\n";

/// Adds examples and exit codes to the help of each command.
void addExamples(CLI::App& app, const std::string& command) {
  std::string text;
  for (const Example& example : kExamples) {
    if (!example.command.starts_with(command)) continue;
    text += fmt::format("  {:<48}  {}\n", example.command, example.purpose);
  }
  app.footer((text.empty() ? "" : "Examples:\n" + text + "\n") + kExitCodes);
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    addExamples(*sub, command + " " + sub->get_name());
  }
}

/// The process of an isolated stage.
void addStageCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("run-stage")->group("");  // hidden
  auto descriptor = std::make_shared<int>();
  command->add_option("descriptor", *descriptor)->required();
  command->callback([descriptor] {
    const engine::SteadyClock clock;
    host::runPluginProcess(*descriptor, {clock, [](const auto& directory, const auto& instance) {
                                           return std::make_unique<record::ArtefactFolder>(
                                               directory, instance);
                                         }});
  });
}

/// The message for a wrong command below the last known one: "'rnu' is no command; ...".
std::string unknownCommand(const CLI::App& app) {
  const CLI::App* last = &app;
  while (!last->get_subcommands().empty()) last = last->get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::App* sub : last->get_subcommands([](const CLI::App*) { return true; })) {
    if (!sub->get_group().empty()) names.push_back(sub->get_name());
  }
  const std::vector<std::string> rest = app.remaining(true);
  if (names.empty() || rest.empty() || rest.front().starts_with('-')) return "";
  const std::string suggestion = config::didYouMean(rest.front(), names);
  return "'" + rest.front() + "' is no command" +
         (suggestion.empty() ? "; it is one of: " + config::listed(names) : suggestion);
}

ExitCode written() {
  if (std::cout.flush()) return ExitCode::Ok;
  return printFailure(ExitCode::Record,
                      "the output cannot be written; look for a full disk or a closed pipe");
}

ExitCode parse(CLI::App& app, std::vector<std::string> words, const Invocation& invocation) {
  try {
    std::ranges::reverse(words);  // CLI11 expects the last word first
    app.parse(words);
    return invocation.exit_code == ExitCode::Ok ? written() : invocation.exit_code;
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknownCommand(app);
    if (!unknown.empty()) return printFailure(ExitCode::Usage, unknown);
    return app.exit(error) == 0 ? written() : ExitCode::Usage;  // 0: a page of help
  } catch (const CLI::Error& error) {                           // of fail()
    return printFailure(static_cast<ExitCode>(error.get_exit_code()), error.what());
  } catch (const engine::Failure& failed) {
    return printFailure(exitCode(failed.kind), failed.what());
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string path = error.path1().string();
    return printFailure(ExitCode::Dataset,
                        (path.empty() ? "" : path + ": ") + error.code().message());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {  // a defect of the host, not of its input data
    return printFailure(ExitCode::Internal, std::string("tolman: internal error: ") + error.what());
  }
}

}  // namespace

ExitCode exitCode(engine::FailureKind kind) {
  constexpr std::array kCodes = {ExitCode::Configuration, ExitCode::Plugin,     ExitCode::Dataset,
                                 ExitCode::PluginFailed,  ExitCode::Record,     ExitCode::Session,
                                 ExitCode::Internal,      ExitCode::Interrupted};
  static_assert(kCodes.size() == engine::kFailureKindNames.size());
  return kCodes.at(static_cast<std::size_t>(kind));
}

ExitCode exitCode(const engine::Outcome& outcome) {
  if (outcome.failure) return exitCode(outcome.failure->kind);
  if (outcome.interrupted) return ExitCode::Interrupted;
  const engine::RunCounters& n = outcome.counters;
  return n.lost_at_end || n.neverTracked() ? ExitCode::TrackingLost : ExitCode::Ok;
}

ExitCode exitCode(const Status& status) {
  const StatusCode code = status.code();
  return code == StatusCode::InvalidParameter ? ExitCode::Usage
         : code == StatusCode::InvalidInput   ? ExitCode::Dataset
                                              : ExitCode::Record;
}

void fail(ExitCode code, const std::string& message) {
  throw CLI::Error("Failed", message, static_cast<int>(code));
}

void failUnless(const Status& status) {
  if (!status.isOk()) fail(exitCode(status), status.message());
}

int runProgram(const std::vector<std::string>& command_line) try {
  prepareStreams();
  limitFragmentation();
  CLI::App app{"Tolman: neurobiologically inspired visual SLAM from swappable plugins.", "tolman"};
  app.require_subcommand(1);
  app.fallthrough();
  Invocation invocation;
  invocation.command_line = command_line;
  addList(app, "--plugin-path", invocation.plugin_paths, "PATH",
          "Folder or library to search first for plugins (repeatable)")
      ->check(CLI::ExistingPath);
  app.add_flag("--json", invocation.json, "Machine-readable output on stdout");
  app.add_flag("-q,--quiet", invocation.quiet, "Only errors");
  for (const auto add : {addRunCommand, addCheckCommand, addPluginsCommand, addInitCommand,
                         addTryCommand, addDatasetCommand, addBenchCommand, addEvalCommand,
                         addExplainCommand, addExportCommand, addReportCommand, addViewCommand,
                         addPlanCommand, addSweepCommand, addCompareCommand, addRerunCommand}) {
    add(app, invocation);
  }
  app.set_version_flag("--version",
                       std::string("tolman ") + engine::kVersion + " (" + engine::kRevision + ")");
  addStageCommand(app);
  addExamples(app, "tolman");
  return static_cast<int>(parse(app, {command_line.begin() + 1, command_line.end()}, invocation));
} catch (const std::bad_alloc&) {
  std::cerr << "tolman: out of memory\n";
  return static_cast<int>(ExitCode::Internal);
}

ExitCode printFailure(ExitCode code, const std::string& message) {
  std::cerr << engine::wipedLine() + config::printable(message, "?") +
                   (message.ends_with('\n') ? "" : "\n");
  return code;
}

std::string jsonText(const nlohmann::ordered_json& json) {
  return config::jsonText(json, 2) + "\n";
}

std::string row(std::string_view name, std::string_view text) {
  return fmt::format("{:<10}{}\n", name, text);
}

void printFiles(const std::vector<std::filesystem::path>& files, const Invocation& invocation) {
  if (std::ranges::any_of(files, record::isStandardOutput)) return;  // it has the contents alone
  auto list = nlohmann::ordered_json::array();
  for (const auto& file : files) {
    list.push_back(file.string());
    if (!invocation.json && !invocation.quiet) std::cout << file.string() << "\n";
  }
  if (invocation.json) std::cout << jsonText({{"files", list}});
}

Terminal terminalOf(const Invocation& invocation) {
  return {isatty(STDERR_FILENO) == 1 && !invocation.quiet, invocation.quiet};
}

std::int64_t framesToCome(std::int64_t wanted, std::int64_t known) {
  return wanted < 0 || known < 0 ? std::max(wanted, known) : std::min(wanted, known);
}

ProgressLine::ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal,
                           std::int64_t total)
    : clock_(clock),
      quiet_(terminal.quiet),
      begin_ns_(clock.steadyNs()),
      display_(out, terminal.interactive) {
  frames_.total = total;
  display_.begin(begin_ns_);
}

void ProgressLine::step() {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  ++frames_.done;
  const std::int64_t now = clock_.steadyNs();
  frames_.seconds = static_cast<double>(now - begin_ns_) * 1e-9;
  if (display_.isDue(frames_, now)) display_.show(frameText(frames_), frames_, now);
}

}  // namespace tolman::app
