// SPDX-License-Identifier: BSD-3-Clause
// The inside of a stage's process: loads one plugin and does what the host asks, until the host
// hangs up or dies.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tolman/context.hpp"

namespace tolman::isolation {

/// What the process provides for its plugin and this folder does not know how to make.
struct ServantServices {
  const Clock& clock;
  /// The writer of `instance` below a run's directory.
  std::function<std::unique_ptr<ArtefactWriter>(const std::filesystem::path& run_directory,
                                                const std::string& instance)>
      artefacts;
};

/// `descriptors`: the four numbers that Worker put behind its command. Does not return: what a
/// plugin left behind may not run at the end of the process.
[[noreturn]] void serve(const std::vector<int>& descriptors, const ServantServices& services);

}  // namespace tolman::isolation
