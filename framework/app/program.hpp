// SPDX-License-Identifier: BSD-3-Clause
// The command line `tolman`.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/exit_code.hpp"
#include "tolman/status.hpp"

namespace CLI {
class App;
}
namespace tolman::record {
class RunReader;
}

namespace tolman::app {

ExitCode exitCode(const Status& status);  ///< for a failure to read or write a file

/// Ends a command; the message goes to stderr.
struct Ended {
  ExitCode code;
  std::string message;
};

/// The value of the result; throws Ended if there is none.
template <class T>
T valueOrEnd(Result<T> result, ExitCode code) {
  if (!result.isOk()) throw Ended{code, result.status().message()};
  return std::move(result).value();
}
template <class T>
T valueOrEnd(Result<T> result) {
  const ExitCode code = exitCode(result.status());
  return valueOrEnd(std::move(result), code);
}

void requireOrEnd(const Status& status);

/// Runs the program; the result is the exit code of the process.
int runProgram(int argc, const char* const* argv);

// Each prints its message on stderr and returns the exit code.
ExitCode printFailure(const run::Failure& failure);
ExitCode printFailure(ExitCode code, const std::string& message);

/// A check of an option's value: without it `--out ""` would take the default.
std::string notEmpty(const std::string& value);
/// A check of an option's value: a folder, or a library with plugins.
std::string pluginPlace(const std::string& path);
// Checks of numbers. Those of CLI11 accept NaN and print ranges with 300 digits.
std::string positive(const std::string& value);
std::string notNegative(const std::string& value);

/// Options and exit code that all commands share.
struct Invocation {
  std::vector<std::string> command_line;
  std::vector<std::string> plugin_paths;
  bool json = false;
  bool quiet = false;
  ExitCode exit_code = ExitCode::Ok;
};

/// Warns on stderr of a run whose run.json is missing or damaged, whose configuration has changed,
/// or that lacks files of its end: it is used, but not silently.
void warnOfRunFiles(const std::string& run);

/// Warns on stderr of a record of which these tables (empty: any) were changed after the run; reads
/// their rows.
void warnOfChangedRecord(const record::RunReader& reader,
                         std::span<const std::string_view> tables = {});

/// Names of the files that a command wrote: lines, with --json a list "files", with --quiet
/// nothing.
void printFiles(const std::vector<std::filesystem::path>& files, const Invocation& invocation);

// Each adds one command to `app`; the command stores its exit code in `invocation`.
void addRunCommand(CLI::App& app, Invocation& invocation);
void addCheckCommand(CLI::App& app, Invocation& invocation);
void addPluginsCommand(CLI::App& app, Invocation& invocation);
void addPluginsNewCommand(CLI::App& plugins, Invocation& invocation);  // below `plugins`
void addValidateCommand(CLI::App& plugins, Invocation& invocation);    // below `plugins`
void addInitCommand(CLI::App& app, Invocation& invocation);
void addProbeCommand(CLI::App& app, Invocation& invocation);  // internal
void addDatasetCommand(CLI::App& app, Invocation& invocation);
void addRenderCommand(CLI::App& dataset, Invocation& invocation);  // below `dataset`
void addImportCommand(CLI::App& dataset, Invocation& invocation);  // likewise
void addBenchCommand(CLI::App& app, Invocation& invocation);
void addEvalCommand(CLI::App& app, Invocation& invocation);
void addPlanCommand(CLI::App& app, Invocation& invocation);
void addReportCommand(CLI::App& app, Invocation& invocation);
void addViewCommand(CLI::App& app, Invocation& invocation);
void addExportCommand(CLI::App& app, Invocation& invocation);
void addSweepCommand(CLI::App& app, Invocation& invocation);
void addCompareCommand(CLI::App& app, Invocation& invocation);
void addRerunCommand(CLI::App& app, Invocation& invocation);
void addStageCommand(CLI::App& app);  // hidden

}  // namespace tolman::app
