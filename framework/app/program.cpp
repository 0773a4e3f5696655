// SPDX-License-Identifier: BSD-3-Clause
#include "app/program.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>

#include "app/help_texts.hpp"
#include "app/help_tree.hpp"
#include "app/memory_reserve.hpp"
#include "app/out_of_memory_end.hpp"
#include "app/terminal_output.hpp"
#include "config/nearest_name.hpp"
#include "config/paths.hpp"
#include "engine/build_info.hpp"
#include "engine/terminal.hpp"
#include "host/manifest.hpp"
#include "record/atomic_file.hpp"
#include "record/export.hpp"
#include "record/run_check.hpp"
#include "record/run_directory.hpp"
#include "record/run_reader.hpp"

namespace tolman::app {
namespace {

/// Adds examples and exit codes to the help of each command.
void addExamples(CLI::App& app, const std::string& command) {
  app.footer(helpFooter(command));
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    addExamples(*sub, command + " " + sub->get_name());
  }
}

std::string versionText() {
  return std::string("tolman ") + run::kVersion + " (" + run::kRevision + ")";
}

/// `help`, which `wordsOf` has replaced before anything is parsed, `version`, and `help-tree`.
void addWordCommands(CLI::App& app, const Invocation& invocation) {
  CLI::App* help = app.add_subcommand("help", "The options of a command; same as COMMAND --help");
  help->add_option("command", "Command, such as run or plugins describe")
      ->type_name("COMMAND")
      ->expected(0, -1);
  app.add_subcommand("version", "Version of the program; same as --version")->callback([&] {
    const nlohmann::ordered_json json = {{"version", run::kVersion}, {"revision", run::kRevision}};
    std::cout << (invocation.json ? jsonText(json) : versionText() + "\n");
  });
  app.add_subcommand("help-tree", "All commands and options as JSON (internal)")
      ->group("")
      ->callback([&app] { std::cout << helpTree(app).dump(1) << "\n"; });
}

std::optional<double> finiteNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

/// The words behind `tolman`, with `help COMMAND` as `COMMAND --help`.
std::vector<std::string> wordsOf(int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  auto command = words.begin();
  while (command != words.end() && command->starts_with('-')) {
    command += *command == "--plugin-path" && command + 1 != words.end() ? 2 : 1;
  }
  if (command == words.end() || *command != "help") return words;
  words.erase(command);
  words.emplace_back("--help");
  return words;
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

/// Creating a thread without memory for its stack fails with "Resource temporarily unavailable".
std::string systemErrorText(const std::system_error& error) {
  if (error.code() == std::errc::resource_unavailable_try_again ||
      error.code() == std::errc::not_enough_memory) {
    return "tolman: out of memory or of threads; give it more (`ulimit -v`, `ulimit -u`)";
  }
  return std::string("tolman: internal error: ") + error.what();
}

bool hasWorkingDirectory() {
  std::error_code ignored;
  return !std::filesystem::current_path(ignored).empty();
}

int parse(CLI::App& app, std::vector<std::string> words) {
  try {
    std::ranges::reverse(words);  // CLI11 expects the last word first
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    const std::string unknown = unknownCommand(app);
    if (!unknown.empty()) return static_cast<int>(printFailure(ExitCode::Usage, unknown));
    return app.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::Usage);
  } catch (const run::Failed& failed) {
    return static_cast<int>(printFailure(failed.failure));
  } catch (const Ended& ended) {
    return static_cast<int>(printFailure(ended.code, ended.message));
  } catch (const std::bad_alloc&) {
    return static_cast<int>(printFailure(ExitCode::Internal, std::string(kOutOfMemory)));
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::filename_too_long) {
      const char* text = "a path of the command line is too long for the file system";
      return static_cast<int>(printFailure(ExitCode::Usage, text));
    }
    if (!hasWorkingDirectory()) {
      const char* text = "the working directory no longer exists; change to one that does";
      return static_cast<int>(printFailure(ExitCode::Usage, text));
    }
    if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
      const std::string text = of_file->path1().string() + ": " +
                               config::absence(of_file->path1(), error.code().message());
      return static_cast<int>(printFailure(ExitCode::Dataset, text));
    }
    return static_cast<int>(printFailure(ExitCode::Internal, systemErrorText(error)));
  } catch (const std::exception& error) {  // a defect of the host, not of its input data
    const std::string text = std::string("tolman: internal error: ") + error.what();
    return static_cast<int>(printFailure(ExitCode::Internal, text));
  }
  return 0;
}

}  // namespace

ExitCode exitCode(const Status& status) {
  const StatusCode code = status.code();
  return code == StatusCode::InvalidParameter ? ExitCode::Usage
         : code == StatusCode::InvalidInput   ? ExitCode::Dataset
                                              : ExitCode::Record;
}

int runProgram(int argc, const char* const* argv) {
  const MemoryReserve for_the_end;
  const OutOfMemoryEnd without_signal;
  CLI::App app{"Tolman: neurobiologically inspired visual SLAM from swappable plugins.", "tolman"};
  app.set_version_flag("--version", versionText());
  app.require_subcommand(1);
  Invocation invocation;
  invocation.command_line.assign(argv, argv + argc);
  app.add_option("--plugin-path", invocation.plugin_paths,
                 "Folder or library to search first for plugins (repeatable)")
      ->type_name("PATH")
      ->check(pluginPlace)
      ->allow_extra_args(false);
  app.add_flag("--json", invocation.json, "Machine-readable output on stdout");
  app.add_flag("-q,--quiet", invocation.quiet, "Only errors");
  app.fallthrough();
  addRunCommand(app, invocation);
  addCheckCommand(app, invocation);
  addPluginsCommand(app, invocation);
  addInitCommand(app, invocation);
  addDatasetCommand(app, invocation);
  addBenchCommand(app, invocation);
  addEvalCommand(app, invocation);
  addExportCommand(app, invocation);
  addReportCommand(app, invocation);
  addViewCommand(app, invocation);
  addPlanCommand(app, invocation);
  addSweepCommand(app, invocation);
  addCompareCommand(app, invocation);
  addRerunCommand(app, invocation);
  addWordCommands(app, invocation);
  addStageCommand(app);
  addProbeCommand(app, invocation);
  addExamples(app, "tolman");
  int code = parse(app, wordsOf(argc, argv));
  if (code == 0) code = static_cast<int>(invocation.exit_code);
  if (std::cout.flush() || code != 0) return code;
  const char* text = "the output cannot be written; look for a full disk or a closed pipe";
  return static_cast<int>(printFailure(ExitCode::Record, text));
}

void requireOrEnd(const Status& status) {
  if (!status.isOk()) throw Ended{exitCode(status), status.message()};
}

void warnOfRunFiles(const std::string& run) {
  const auto run_file = record::RunDirectory::readRunFile(run);
  for (const Status& status : {record::RunDirectory::checkRunFile(run),
                               record::checkConfig(run, run_file), record::checkEndFiles(run)}) {
    if (!status.isOk()) std::cerr << "warning: " + run::printable(status.message()) + "\n";
  }
}

void warnOfChangedRecord(const record::RunReader& reader,
                         std::span<const std::string_view> tables) {
  const Status status = record::checkRows(reader, tables);
  if (!status.isOk()) {
    std::cerr << "warning: " + run::printable(status.message()) +
                     "; this output is of the changed record\n";
  }
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

std::string positive(const std::string& value) {
  return finiteNumber(value).value_or(0) > 0 ? "" : "must be a number above 0";
}

std::string notNegative(const std::string& value) {
  return finiteNumber(value).value_or(-1) >= 0 ? "" : "must be a number of at least 0";
}

std::string pluginPlace(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return "'" + path + "' " + config::absence(path, "does not exist");
  }
  if (std::filesystem::is_directory(path, ignored)) return "";
  const auto read = host::readManifests(path);
  const auto* refusal = std::get_if<host::Refusal>(&read);
  return refusal == nullptr ? "" : refusal->text();
}

std::string notEmpty(const std::string& value) { return value.empty() ? "must not be empty" : ""; }

ExitCode printFailure(ExitCode code, const std::string& message) {
  std::cerr << run::wipedLine(STDERR_FILENO) + run::printable(message) +
                   (message.ends_with('\n') ? "" : "\n");
  return code;
}

ExitCode printFailure(const run::Failure& failure) {
  return printFailure(exitCode(failure.kind), failure.message);
}

}  // namespace tolman::app
