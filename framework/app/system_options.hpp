// SPDX-License-Identifier: BSD-3-Clause
// Options of all commands that read a configuration.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/assembly.hpp"
#include "app/program.hpp"

namespace tolman::app {

/// CONFIG, --set, --seed, --threads, --continue.
class SystemOptionsReader {
 public:
  explicit SystemOptionsReader(CLI::App& command) {
    command.add_option("config", config_, "Configuration file (YAML)")->required();
    command.add_option("--set", overrides_, "Override a value: --set a.b=c (repeatable)")
        ->allow_extra_args(false);
    command.add_option("--seed", seed_, "Seed of the run; same as --set seed=N");
    command.add_option("--threads", threads_, "Threads, 0 for all; same as --set threads=N");
  }

  /// Of commands that drive a run.
  void addContinue(CLI::App& command) {
    command.add_option("--continue", continue_,
                       "Go on with the map of this run directory; same as --set continue=DIR");
  }

  SystemOptions read(const Invocation& invocation) const {
    SystemOptions options{config_, overrides_, invocation.plugin_paths};
    if (!seed_.empty()) options.overrides.push_back("seed=" + seed_);
    if (!threads_.empty()) options.overrides.push_back("threads=" + threads_);
    if (!continue_.empty()) options.overrides.push_back("continue=" + continue_);
    return options;
  }

 private:
  std::string config_;
  std::vector<std::string> overrides_;
  std::string seed_;
  std::string threads_;
  std::string continue_;
};

}  // namespace tolman::app
