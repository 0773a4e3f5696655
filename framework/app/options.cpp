// SPDX-License-Identifier: BSD-3-Clause
#include "app/options.hpp"

#include <algorithm>

#include "base/text_file.hpp"
#include "config/text.hpp"
#include "config/values.hpp"
#include "record/atomic_file.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;
using text_encoding::parseNumber;

/// Whether writing the file would lose something. Links count as files: they would be replaced.
bool isInTheWay(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file, ignored))) return false;
  if (fs::is_other(file, ignored) || record::isStandardOutput(file)) return false;
  return fs::is_symlink(file, ignored) || !fs::is_empty(file, ignored);
}

}  // namespace

CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& text) {
  std::string type;
  for (const std::string& one : names) type += (type.empty() ? "" : "|") + one;
  return addOption(command, name, value, type, text)->check([names](const std::string& given) {
    const bool known = std::ranges::find(names, given) != names.end();
    if (known) return std::string();
    return "'" + given + "' is not one of " + config::listed(names) +
           config::didYouMean(given, names);
  });
}

std::string notEmpty(const std::string& value) { return value.empty() ? "must not be empty" : ""; }

std::string positive(const std::string& value) {
  return parseNumber(value).value_or(0) > 0 ? "" : "must be a number above 0";
}

std::string notNegative(const std::string& value) {
  return parseNumber(value).value_or(-1) >= 0 ? "" : "must be a number of at least 0";
}

std::string isAssignment(const std::string& value) {
  const std::size_t equals = value.find('=');
  const bool has_both = equals != std::string::npos && equals > 0;
  return has_both ? "" : "'" + value + "': write it as NAME=VALUE";
}

std::pair<std::string, std::string> sidesOf(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  return {assignment.substr(0, equals), assignment.substr(equals + 1)};
}

CLI::Option* Output::add(CLI::App& command, const std::string& type, const std::string& text,
                         const std::string& replaced) {
  command.add_flag("--force", replace, replaced);
  return addOption(command, "--out", path, type, text)->check(notEmpty);
}

void refuseExisting(const std::vector<fs::path>& files, bool replace, const std::string& option) {
  if (replace) return;
  const auto found = std::ranges::find_if(files, isInTheWay);
  if (found == files.end()) return;
  fail(ExitCode::Record,
       found->string() + ": exists; choose another " + option + ", or replace it with --force");
}

fs::path thisProgram() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored);
}

fs::path shippedConfig(const std::string& name) {
  std::error_code ignored;
  const fs::path prefix = thisProgram().parent_path().parent_path();
  for (const fs::path& folder : {prefix / "share/tolman", prefix.parent_path()}) {
    for (const fs::path& file : {folder / "configs" / (name + ".yaml"), folder / name}) {
      if (fs::is_regular_file(file, ignored)) return file;
    }
  }
  return {};
}

std::string configFile(const std::string& given) {
  std::error_code ignored;
  const bool is_file = fs::exists(given, ignored) && !fs::is_directory(given, ignored);
  const fs::path shipped = is_file ? "" : shippedConfig(given);
  return shipped.empty() ? given : shipped.string();
}

SystemOptionsReader::SystemOptionsReader(CLI::App& command) : command_(command) {
  addArgument(command, "config", config_, "CONFIG",
              "Configuration file (YAML), the name of a shipped one, or a recording");
  addList(command, "--set", overrides_, "PATH=VALUE", "Override a value: --set a.b=c (repeatable)");
  addOption(command, "--seed", seed_, "N", "Seed of the run; same as --set seed=N");
  addOption(command, "--threads", threads_, "N", "Threads, 0 for all; same as --set threads=N");
}

void SystemOptionsReader::addContinue() {
  addOption(command_, "--continue", continue_, "RUN",
            "Continue the map of this run directory; same as --set continue=DIR");
  addOption(command_, "--localise", localise_, "RUN",
            "Find the robot in the map of this run directory, which stays as it is")
      ->excludes(command_.get_option("--continue"));
  CLI::Option* resume = addOption(command_, "--resume", resume_, "RUN",
                                  "Go on with this interrupted or killed run, in its directory "
                                  "and with its configuration");
  command_.get_option("config")->required(false);
  for (const char* other : {"config", "--set", "--seed", "--threads", "--continue", "--localise"}) {
    resume->excludes(command_.get_option(other));  // a resumed run keeps its options
  }
}

engine::SystemOptions SystemOptionsReader::read(const Invocation& invocation, Use use) const {
  if (config_.empty() && resume_.empty()) {
    throw CLI::RequiredError("a configuration, or --resume,");
  }
  engine::SystemOptions options{
      resume_.empty() ? configFile(config_) : configOfRun(resume_, ExitCode::Session), overrides_,
      invocation.plugin_paths};
  options.quiet = invocation.quiet;
  options.find_shipped = shippedConfig;
  if (resume_.empty()) options = withRecording(std::move(options), invocation, use);
  if (!seed_.empty()) options.overrides.push_back("seed=" + seed_);
  if (!threads_.empty()) options.overrides.push_back("threads=" + threads_);
  if (!continue_.empty()) options.overrides.push_back("continue=" + config::writeText(continue_));
  if (!localise_.empty()) options.overrides.push_back("localise=" + config::writeText(localise_));
  return options;
}

std::string configOfRun(const fs::path& run, ExitCode code) {
  const fs::path file = run / "config.resolved.yaml";
  std::error_code ignored;
  if (fs::is_regular_file(file, ignored)) return file;
  fail(code, run.string() + ": " +
                 config::absence(file,
                                 "is no run directory, it holds no config.resolved.yaml; give "
                                 "the folder that a run has written"));
}

}  // namespace tolman::app
