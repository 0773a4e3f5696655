// SPDX-License-Identifier: BSD-3-Clause
#include "app/output_files.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <iterator>

#include "app/program.hpp"
#include "record/atomic_file.hpp"
#include "record/output_places.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

/// Whether writing the file would lose something. Links count as files: they would be replaced.
bool isInTheWay(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file, ignored))) return false;
  if (fs::is_other(file, ignored) || record::isStandardOutput(file)) return false;
  if (fs::is_directory(file, ignored)) return !fs::is_empty(file, ignored);
  return fs::is_symlink(file, ignored) || fs::file_size(file, ignored) > 0;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& option) {
  throw Ended{ExitCode::Record, file.string() + ": exists; choose another " + option +
                                    ", or replace it with --force"};
}

}  // namespace

void addForce(CLI::App& command, bool& replace, const std::string& what) {
  command.add_flag("--force", replace, what);
}

void refuseExisting(const std::vector<fs::path>& files, bool replace, const std::string& option,
                    const std::function<bool(const fs::path&)>& is_own) {
  for (const fs::path& file : files) {
    requireOrEnd(record::refuseRunPlaces(file, option));
  }
  std::vector<fs::path> others;
  std::ranges::copy_if(files, std::back_inserter(others), std::not_fn(is_own));
  requireOrEnd(record::refuseFolders(files, option));
  refuseReplacing(others, replace, option);
}

void refuseReplacing(const std::vector<fs::path>& files, bool replace, const std::string& option) {
  requireOrEnd(record::refuseFolders(files, option));
  if (replace) return;
  for (const fs::path& file : files) {
    if (isInTheWay(file)) refuse(file, option);
  }
}

void refuseFilled(const fs::path& folder, bool replace, const std::string& option) {
  if (!replace && isInTheWay(folder)) refuse(folder, option);
}

}  // namespace tolman::app
