// SPDX-License-Identifier: BSD-3-Clause
// Options of commands: adding them, checking their values, and the groups that commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/program.hpp"
#include "app/recording.hpp"
#include "engine/checked_system.hpp"

namespace tolman::app {

/// Adds an option, or for a name without dashes an argument. `type` names its value in the help.
template <class T>
CLI::Option* addOption(CLI::App& command, const std::string& name, T& value,
                       const std::string& type, const std::string& text) {
  return command.add_option(name, value, text)->type_name(type);
}
/// An argument that must be given.
template <class T>
CLI::Option* addArgument(CLI::App& command, const std::string& name, T& value,
                         const std::string& type, const std::string& text) {
  return addOption(command, name, value, type, text)->required();
}
/// An option with one value, which may be given several times.
template <class T>
CLI::Option* addList(CLI::App& command, const std::string& name, std::vector<T>& values,
                     const std::string& type, const std::string& text) {
  return addOption(command, name, values, type, text)->allow_extra_args(false);
}
/// An option whose value is one of these names.
CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& text);

// Checks of values. Those of CLI11 accept NaN and print ranges with 300 digits.
std::string notEmpty(const std::string& value);  ///< without it `--out ""` would take the default
std::string positive(const std::string& value);
std::string notNegative(const std::string& value);
std::string isAssignment(const std::string& value);  ///< NAME=VALUE

/// The two sides of an assignment.
std::pair<std::string, std::string> sidesOf(const std::string& assignment);

/// --out and --force of the commands that write files where the user chooses.
struct Output {
  std::string path;
  bool replace = false;

  /// Adds both options.
  CLI::Option* add(CLI::App& command, const std::string& type, const std::string& text,
                   const std::string& replaced);
};

/// To be called before the command begins its work: fails (8) if one of `files` exists and
/// `replace` is not set. `option` is the option that chose them. Allowed without --force: an empty
/// file or folder, as `mktemp` makes them, and pipes, devices and the standard output, which are
/// not replaced.
void refuseExisting(const std::vector<std::filesystem::path>& files, bool replace,
                    const std::string& option);

/// A configuration shipped with the program, in the installed or the build tree: both "demo" and
/// "configs/demo.yaml" name it. Empty where there is none.
std::filesystem::path shippedConfig(const std::string& name);
/// The file `given`. If there is none, the shipped configuration of this name.
std::string configFile(const std::string& given);

/// This program: PREFIX/bin/tolman.
std::filesystem::path thisProgram();

/// CONFIG, --set, --seed, --threads, --continue, --localise, --resume. CONFIG may be a recording:
/// it is read with the configuration that `tolman init` writes for it.
class SystemOptionsReader {
 public:
  explicit SystemOptionsReader(CLI::App& command);
  /// For commands that record a run.
  void addContinue();

  /// The run directory that --resume names; empty when there is none.
  const std::string& resumed() const { return resume_; }
  engine::SystemOptions read(const Invocation& invocation, Use use = Use::Run) const;

 private:
  CLI::App& command_;
  std::string config_;
  std::vector<std::string> overrides_;
  std::string seed_;
  std::string threads_;
  std::string continue_;
  std::string localise_;
  std::string resume_;
};

/// The configuration with which the run was recorded. Fails with `code` where there is none.
std::string configOfRun(const std::filesystem::path& run, ExitCode code);

}  // namespace tolman::app
