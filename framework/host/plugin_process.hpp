// SPDX-License-Identifier: BSD-3-Clause
// Main function of the process of an isolated plugin: loads the plugin and executes calls until the
// host closes the connection or ends.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tolman/context.hpp"

namespace tolman::isolation {

/// Exit code of a process that has too little memory to answer.
inline constexpr int kNoMemoryExit = 71;
/// Exit code of a process that cannot start the threads it needs.
inline constexpr int kNoThreadsExit = 72;

/// Services of the plugin's context that are implemented outside of this folder.
struct ProcessServices {
  const Clock& clock;
  /// Creates the artefact writer of `instance` in the directory of a run.
  std::function<std::unique_ptr<ArtefactWriter>(const std::filesystem::path& run_directory,
                                                const std::string& instance)>
      artefacts;
};

/// `descriptors` are the five that ProcessHandle appends to its command. Ends the process without
/// returning, so that no static destructor of the plugin runs.
[[noreturn]] void runPluginProcess(const std::vector<int>& descriptors,
                                   const ProcessServices& services);

}  // namespace tolman::isolation
