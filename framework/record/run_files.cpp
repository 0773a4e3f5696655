// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_files.hpp"

#include <array>
#include <string>
#include <system_error>
#include <vector>

#include "record/export.hpp"
#include "record/output_places.hpp"
#include "record/run_directory.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

constexpr std::array kRecordFiles = {"run.sqlite",          "run.sqlite-wal", "run.sqlite-shm",
                                     "run.sqlite-journal",  "run.json",       "log.txt",
                                     "config.resolved.yaml"};
constexpr std::array kDerivedFiles = {"metrics.json", "report.html", "results.sha256", "map.svg",
                                      "run.npz",      "run.nwb",     "figures"};

/// The name without the affixes of writeAtomically(): a killed program leaves its temporary files.
std::string finalName(const std::string& name) {
  const std::size_t partial = name.rfind(".partial");
  const bool is_temporary = name.starts_with('.') && partial != std::string::npos && partial > 0;
  return is_temporary ? name.substr(1, partial - 1) : name;
}

/// Removes files, and folders with all that is in them; keeps the first failure.
template <class Names>
void removeAll(const fs::path& directory, const Names& names, Status& status) {
  for (const auto& name : names) {
    std::error_code error;
    if (status.isOk()) fs::remove_all(directory / name, error);
    if (error) status = Status::failed((directory / name).string() + ": " + error.message());
  }
}

/// Temporary files of a killed program in this folder, and the folders of earlier sessions.
std::vector<fs::path> remainsIn(const fs::path& directory) {
  std::vector<fs::path> remains;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    if (finalName(name) != name) remains.push_back(entry.path());
    if (name.starts_with("session-") && entry.is_directory(error)) remains.push_back(entry.path());
  }
  return remains;
}

/// The state that a run leaves if it could not write its first file.
bool holdsOnlyEmptyLog(const fs::path& directory) {
  std::error_code error;
  fs::directory_iterator entry(directory, error);
  return !error && entry != fs::directory_iterator() && entry->path().filename() == "log.txt" &&
         entry->is_regular_file(error) && entry->file_size(error) == 0 &&
         ++entry == fs::directory_iterator();
}

}  // namespace

bool holdsRun(const fs::path& directory) {
  return holdsOnlyEmptyLog(directory) || holdsRecordedRun(directory);
}

bool holdsRecordedRun(const fs::path& directory) {
  std::error_code ignored;
  return fs::exists(directory / "run.sqlite", ignored) ||
         RunDirectory::checkRunFile(directory).isOk() ||
         (fs::exists(directory / "run.json", ignored) &&
          fs::exists(directory / "config.resolved.yaml", ignored));
}

Status removeDerivedFiles(const fs::path& directory) {
  Status status;
  removeAll(directory, kExportedFiles, status);
  removeAll(directory, kDerivedFiles, status);
  for (const fs::path& remains : remainsIn(directory)) {
    std::error_code kept;  // a folder in which the user has files
    if (fs::is_directory(remains)) removeAll(remains, kExportedFiles, status);
    if (status.isOk()) fs::remove(remains, kept);
  }
  return status;
}

Status removeRunFiles(const fs::path& directory) {
  Status status = removeDerivedFiles(directory);
  removeAll(directory, kRunFolders, status);
  removeAll(directory, kRecordFiles, status);
  return status;
}

}  // namespace tolman::record
