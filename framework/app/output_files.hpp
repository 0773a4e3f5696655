// SPDX-License-Identifier: BSD-3-Clause
// The one rule for files that a command writes to places that the user chose: a file that exists is
// replaced only with --force.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tolman::app {

/// Adds --force, which sets `replace`.
void addForce(CLI::App& command, bool& replace, const std::string& what);

/// To be called before the command begins its work: throws Ended (8) if one of `files` exists and
/// `replace` is not set, and always if one is a folder or lies in the directory of a
/// run (output_places.hpp). `option` is the option that chose them. Allowed without it: an empty
/// file, as `mktemp` makes it; pipes, devices and the standard output, which are not replaced; and
/// files for which `is_own` is true.
void refuseExisting(
    const std::vector<std::filesystem::path>& files, bool replace, const std::string& option,
    const std::function<bool(const std::filesystem::path&)>& is_own = [](const auto&) {
      return false;
    });

/// The same without the rule of places: for outputs of which the caller has asked
/// RunDirectory::mayTakeFilesOf(), which allows the directory of the run that the command is about.
void refuseReplacing(const std::vector<std::filesystem::path>& files, bool replace,
                     const std::string& option);

/// The same for a folder that is filled with files: it must be absent or empty.
void refuseFilled(const std::filesystem::path& folder, bool replace, const std::string& option);

}  // namespace tolman::app
