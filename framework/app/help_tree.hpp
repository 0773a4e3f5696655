// SPDX-License-Identifier: BSD-3-Clause
// The commands and their options as data, for the completion of shells and the manual pages
// (scripts/generate-help).
#pragma once

#include <nlohmann/json.hpp>

namespace CLI {
class App;
}

namespace tolman::app {

/// Program, version, exit codes and the tree of commands. Each command has its name, the words that
/// call it, its text, options, positional arguments, examples and subcommands; each option its
/// names, text, value and what a shell can offer for it (see `kindOf`). Hidden commands and options
/// are left out.
nlohmann::ordered_json helpTree(const CLI::App& app);

}  // namespace tolman::app
