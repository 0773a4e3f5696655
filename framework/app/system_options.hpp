// SPDX-License-Identifier: BSD-3-Clause
// Options of all commands that read a configuration.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "app/source_overrides.hpp"
#include "config/scalars.hpp"
#include "engine/checked_system.hpp"

namespace tolman::app {

/// A configuration shipped with the program, in the installed or the build tree: both "demo" and
/// "configs/demo.yaml" name it. Empty where there is none.
inline std::filesystem::path shippedConfig(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  for (const fs::path& folder : {prefix / "share/tolman", prefix.parent_path()}) {
    for (const fs::path& file : {folder / "configs" / (name + ".yaml"), folder / name}) {
      if (fs::is_regular_file(file, ignored)) return file;
    }
  }
  return {};
}

/// The file `given`. If there is none, the shipped configuration of this name.
inline std::string configFile(const std::string& given) {
  std::error_code ignored;
  const bool is_file =
      std::filesystem::exists(given, ignored) && !std::filesystem::is_directory(given, ignored);
  const std::filesystem::path shipped = is_file ? "" : shippedConfig(given);
  return shipped.empty() ? given : shipped.string();
}

/// CONFIG, --set, --seed, --threads, --continue, --resume.
class SystemOptionsReader {
 public:
  explicit SystemOptionsReader(CLI::App& command) {
    command
        .add_option("config", config_, "Configuration file (YAML), or the name of a shipped one")
        ->type_name("CONFIG")
        ->required();
    command.add_option("--set", overrides_, "Override a value: --set a.b=c (repeatable)")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    command.add_option("--seed", seed_, "Seed of the run; same as --set seed=N")->type_name("N");
    command.add_option("--threads", threads_, "Threads, 0 for all; same as --set threads=N")
        ->type_name("N");
  }

  /// For commands that record a run.
  void addContinue(CLI::App& command) {
    command
        .add_option("--continue", continue_,
                    "Continue the map of this run directory; same as --set continue=DIR")
        ->type_name("RUN");
    command.get_option("config")->required(false);
    command
        .add_option("--resume", resume_,
                    "Go on with this interrupted or killed run, in its directory and with its "
                    "configuration")
        ->type_name("RUN");
    command_ = &command;
  }

  /// The run directory that --resume names; empty when there is none.
  const std::string& resumed() const { return resume_; }

  run::SystemOptions read(const Invocation& invocation) const {
    if (config_.empty() && resume_.empty()) {
      throw CLI::RequiredError("a configuration, or --resume,");
    }
    for (const std::string& run : {continue_, resume_}) {
      requireKind(run, {PathKind::Run, PathKind::Folder}, "a run directory", ExitCode::Session);
    }
    if (!resume_.empty()) {
      refuseOthers();
      requireRun();
    }
    refuseTwoValues(overrides_);
    const std::string config =
        resume_.empty() ? configFile(config_) : resume_ + "/config.resolved.yaml";
    if (resume_.empty()) {
      requireKind(config, {PathKind::Configuration}, "a configuration", ExitCode::Configuration);
    }
    run::SystemOptions options{config, overrides_, invocation.plugin_paths};
    options.quiet = invocation.quiet;
    options.find_shipped = shippedConfig;
    addOption("seed", seed_, options.overrides);
    addOption("threads", threads_, options.overrides);
    if (!continue_.empty()) options.overrides.push_back("continue=" + config::writeText(continue_));
    return options;
  }

 private:
  /// --seed N and --set seed=M: neither is certainly meant.
  void addOption(const std::string& name, const std::string& value,
                 std::vector<std::string>& overrides) const {
    if (value.empty()) return;
    for (const std::string& other : overrides_) {
      if (other.starts_with(name + "=")) {
        throw CLI::ExcludesError("--" + name, "--set " + name + "=...");
      }
    }
    overrides.push_back(name + "=" + value);
  }

  /// Without this a folder that is no run would be a configuration that cannot be read.
  void requireRun() const {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(resume_ + "/config.resolved.yaml", ignored)) return;
    const bool exists = std::filesystem::exists(resume_, ignored);
    const std::string missing =
        exists ? "is no run directory, it holds no config.resolved.yaml; give the folder that a "
                 "run has written"
               : "there is no such run directory; give the folder that a run has written";
    throw Ended{ExitCode::Session,
                resume_ + ": " + config::absence(resume_ + "/config.resolved.yaml", missing)};
  }

  /// A resumed run keeps its options, so --resume excludes them.
  void refuseOthers() const {
    for (const char* other :
         {"config", "--set", "--seed", "--threads", "--out", "--force", "--continue"}) {
      if (command_->count(other) > 0) throw CLI::ExcludesError("--resume", other);
    }
  }

  const CLI::App* command_ = nullptr;  ///< set where --resume is an option
  std::string config_;
  std::vector<std::string> overrides_;
  std::string seed_;
  std::string threads_;
  std::string continue_;
  std::string resume_;
};

}  // namespace tolman::app
