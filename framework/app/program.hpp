// SPDX-License-Identifier: BSD-3-Clause
// The command line `tolman`: its commands, how they end, and what they share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress_display.hpp"
#include "engine/failure.hpp"
#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace CLI {
class App;
}

namespace tolman::engine {

struct Outcome;
}

namespace tolman::app {

/// How the program ends; docs/errors.md lists the same for users.
enum class ExitCode : int {
  Ok = 0,
  Usage = 2,
  Configuration = 3,
  Plugin = 4,
  Dataset = 5,
  TrackingLost = 6,
  PluginFailed = 7,
  Record = 8,
  Session = 9,
  Internal = 70,
  Interrupted = 130,
};

ExitCode exitCode(engine::FailureKind kind);
ExitCode exitCode(const engine::Outcome& outcome);
ExitCode exitCode(const Status& status);  ///< for a failure to read or write a file

/// Ends the command with this code; the message goes to stderr.
[[noreturn]] void fail(ExitCode code, const std::string& message);
void failUnless(const Status& status);

/// The value of the result; fail() if there is none.
template <class T>
T valueOf(Result<T> result, ExitCode code) {
  if (!result.isOk()) fail(code, result.status().message());
  return std::move(result).value();
}
template <class T>
T valueOf(Result<T> result) {
  const ExitCode code = exitCode(result.status());
  return valueOf(std::move(result), code);
}

/// Runs the program; the result is the exit code of the process.
int runProgram(const std::vector<std::string>& command_line);

/// Prints the message on stderr and returns the code.
ExitCode printFailure(ExitCode code, const std::string& message);

/// Options and exit code that all commands share.
struct Invocation {
  std::vector<std::string> command_line;
  std::vector<std::string> plugin_paths;
  bool json = false;
  bool quiet = false;
  ExitCode exit_code = ExitCode::Ok;
};

/// Indented JSON with a line feed at the end; bytes that are not UTF-8 become U+FFFD.
std::string jsonText(const nlohmann::ordered_json& json);

/// One row of a summary: a name of ten columns, and a text.
std::string row(std::string_view name, std::string_view text);

/// Names of the files that a command wrote: lines, with --json a list "files", with --quiet
/// nothing.
void printFiles(const std::vector<std::filesystem::path>& files, const Invocation& invocation);

// Each adds one command to `app`; the command stores its exit code in `invocation`.
void addRunCommand(CLI::App& app, Invocation& invocation);
void addCheckCommand(CLI::App& app, Invocation& invocation);
void addPluginsCommand(CLI::App& app, Invocation& invocation);
void addPluginsNewCommand(CLI::App& plugins, Invocation& invocation);  // below `plugins`
void addInitCommand(CLI::App& app, Invocation& invocation);
void addDatasetCommand(CLI::App& app, Invocation& invocation);
void addRenderCommand(CLI::App& dataset, Invocation& invocation);  // below `dataset`
void addBagCommand(CLI::App& dataset, Invocation& invocation);     // likewise
void addBenchCommand(CLI::App& app, Invocation& invocation);
void addEvalCommand(CLI::App& app, Invocation& invocation);
void addPlanCommand(CLI::App& app, Invocation& invocation);
void addExplainCommand(CLI::App& app, Invocation& invocation);
void addReportCommand(CLI::App& app, Invocation& invocation);
void addViewCommand(CLI::App& app, Invocation& invocation);
void addExportCommand(CLI::App& app, Invocation& invocation);
void addSweepCommand(CLI::App& app, Invocation& invocation);
void addCompareCommand(CLI::App& app, Invocation& invocation);
void addTryCommand(CLI::App& app, Invocation& invocation);
void addRerunCommand(CLI::App& app, Invocation& invocation);

/// Runs a sweep as `tolman sweep FILE --out OUT` does. `jobs`: at a time; 0: one per processor.
ExitCode runSweep(const std::filesystem::path& file, const std::filesystem::path& out,
                  std::size_t jobs, const Invocation& invocation);

// Progress, on stderr, of a command that reads frames without a pipeline.

/// Kind of stderr, and whether the user wants output there.
struct Terminal {
  bool interactive = false;  ///< stderr is a terminal, on which a line can be redrawn
  bool quiet = false;        ///< show nothing
};
Terminal terminalOf(const Invocation& invocation);

/// The number of frames to expect when at most `wanted` (-1: all) of `known` (-1: unknown) are
/// read.
std::int64_t framesToCome(std::int64_t wanted, std::int64_t known);

class ProgressLine {
 public:
  /// `total`: frames to come; -1: not known.
  ProgressLine(std::ostream& out, const Clock& clock, Terminal terminal, std::int64_t total);
  /// One more frame is done. May be called from any thread.
  void step();

 private:
  const Clock& clock_;
  bool quiet_;
  std::mutex mutex_;
  FrameCount frames_;
  std::int64_t begin_ns_;
  ProgressDisplay display_;
};

}  // namespace tolman::app
