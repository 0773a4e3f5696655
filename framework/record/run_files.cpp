// SPDX-License-Identifier: BSD-3-Clause
#include "record/run_files.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <system_error>

#include "record/export.hpp"
#include "record/output_places.hpp"
#include "record/regular_file.hpp"
#include "record/run_directory.hpp"

namespace tolman::record {
namespace {

namespace fs = std::filesystem;

using Names = std::function<bool(const fs::path& below)>;

constexpr std::array kRecordFiles = {
    "run.sqlite", "run.sqlite-wal", "run.sqlite-shm", "run.sqlite-journal",
    "run.json",   "log.txt",        "answers.bin",    "config.resolved.yaml"};
constexpr std::array kResultFiles = {"metrics.json", "report.html", "results.sha256",
                                     "map.svg",      "run.npz",     "run.nwb"};

/// The name without the affixes of writeAtomically(): a killed program leaves its temporary files.
std::string finalName(const std::string& name) {
  const std::size_t partial = name.rfind(".partial");
  const bool is_temporary = name.starts_with('.') && partial != std::string::npos && partial > 0;
  return is_temporary ? name.substr(1, partial - 1) : name;
}

bool isExported(const std::string& name) {
  return std::ranges::find(kExportedFiles, name) != kExportedFiles.end();
}

/// Files of a report of one run are in `figures`, of several runs in `figures/RUN`.
bool isFigure(const fs::path& below) {
  const std::string name = finalName(below.filename().string());
  if (std::distance(below.begin(), below.end()) > 2) return false;
  if (name == "neurons.json") return true;
  const fs::path file(name);
  const bool is_picture = file.extension() == ".svg" || file.extension() == ".png";
  return is_picture && std::ranges::find(kFigureNames, file.stem().string()) != kFigureNames.end();
}

bool isState(const fs::path& below) {
  if (below.has_parent_path()) return false;
  const std::string name = finalName(below.string());
  const std::string role = name.substr(name.rfind('-') + 1);  // all of it without a prefix
  const bool is_stage = role == "place.bin" || role == "cells.bin" || role == "map.bin";
  const bool has_prefix = name.starts_with("checkpoint-");
  return name == "session.json" || name == "checkpoint.json" ||
         (is_stage && (has_prefix || role == name));
}

std::set<std::string> listedArtefacts(const fs::path& folder) {
  std::set<std::string> listed;
  std::ifstream list = openRegular(folder / kArtefactList);
  for (std::string line; std::getline(list, line, '\0');) listed.insert(line);
  return listed;
}

/// Removes files one by one, and keeps the first failure.
class Removal {
 public:
  Removal(fs::path directory, std::vector<fs::path>& kept)
      : directory_(std::move(directory)), kept_(kept) {}

  void file(const fs::path& path) {
    std::error_code error;
    if (status_.isOk()) fs::remove(path, error);
    if (error && status_.isOk()) status_ = Status::failed(path.string() + ": " + error.message());
  }

  /// Removes the files below `folder` for which `is_own` is true, and the folders that are then
  /// empty.
  void folder(const std::string& name, const Names& is_own) {
    const fs::path folder = directory_ / name;
    std::error_code error;
    if (!status_.isOk() || !fs::is_directory(folder, error)) return;
    std::vector<fs::path> folders{folder};
    std::vector<fs::path> files;
    for (auto entry = fs::recursive_directory_iterator(folder, error);
         !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
      const bool is_folder = entry->is_directory(error) && !entry->is_symlink(error);
      (is_folder ? folders : files).push_back(entry->path());
    }
    for (const fs::path& path : files) {
      if (is_own(path.lexically_relative(folder))) {
        file(path);
      } else {
        kept_.push_back(path.lexically_relative(directory_));
      }
    }
    std::ranges::reverse(folders);                                 // the inner ones first
    for (const fs::path& path : folders) fs::remove(path, error);  // fails if it is not empty
  }

  const Status& status() const { return status_; }

 private:
  fs::path directory_;
  std::vector<fs::path>& kept_;
  Status status_;
};

void removeDerived(Removal& removal, const fs::path& directory) {
  for (const std::string_view name : kExportedFiles) removal.file(directory / name);
  for (const char* name : kResultFiles) removal.file(directory / name);
  removal.folder("figures", isFigure);
  std::error_code error;
  std::vector<std::string> sessions;
  for (const auto& entry : fs::directory_iterator(directory, error)) {
    const std::string name = entry.path().filename().string();
    const bool is_folder = entry.is_directory(error) && !entry.is_symlink(error);
    if (name.starts_with("session-") && is_folder) sessions.push_back(name);
  }
  for (const std::string& session : sessions) {
    removal.folder(session, [](const fs::path& below) {
      return !below.has_parent_path() && isExported(finalName(below.string()));
    });
  }
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

Status removeDerivedFiles(const fs::path& directory, std::vector<fs::path>& kept) {
  const Status linked = refuseLinks(directory, kRunFolders);
  if (!linked.isOk()) return linked;
  Removal removal(directory, kept);
  removeDerived(removal, directory);
  return removal.status();
}

Status removeRunFiles(const fs::path& directory, std::vector<fs::path>& kept) {
  const Status linked = refuseLinks(directory, kRunFolders);
  if (!linked.isOk()) return linked;
  Removal removal(directory, kept);
  const std::set<std::string> artefacts = listedArtefacts(directory / "artefacts");
  removal.folder("artefacts", [&](const fs::path& below) {
    const fs::path parent = below.parent_path();
    return below == kArtefactList ||
           artefacts.contains((parent / finalName(below.filename().string())).string());
  });
  removal.folder("state", isState);
  removeDerived(removal, directory);
  for (const char* name : kRecordFiles) removal.file(directory / name);
  return removal.status();
}

}  // namespace tolman::record
