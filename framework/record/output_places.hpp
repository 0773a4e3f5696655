// SPDX-License-Identifier: BSD-3-Clause
// Where commands may write: not through links into other folders, not into the directory of a run
// (but for commands about that run), and several files only if each of them can be written.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::record {

/// Folders of a run directory whose files belong to the run alone.
inline constexpr std::array<std::string_view, 3> kRunFolders = {"figures", "artefacts", "state"};

/// The one path of a file that need not exist: absolute, without dots, links followed.
std::filesystem::path truePath(const std::filesystem::path& path);

/// Failed if one of these folders in `directory` is a symbolic link: files would be removed and
/// written in another folder.
Status refuseLinks(const std::filesystem::path& directory,
                   std::span<const std::string_view> folders);

/// The run directory in which the path lies, at any depth; empty if in none, or if it is one.
std::optional<std::filesystem::path> runAround(const std::filesystem::path& path);

/// Failed if the path lies in the directory of a run, at any depth. `own`: the run that the command
/// is about, empty if none; in its directory only kRunFolders are refused. `option`: what chose the
/// path, for the remedy.
Status refuseRunPlaces(const std::filesystem::path& path, const std::string& option,
                       const std::filesystem::path& own = {});

struct OutputFile {
  std::filesystem::path path;
  std::string bytes;
};

/// Writes all files by writeOutput(); none if one is a folder, or if a folder is missing or
/// read-only.
Status writeTogether(const std::vector<OutputFile>& files, const std::string& option);

/// The artefacts of one plugin instance. Writes below <run>/artefacts/<instance>/ only: names with
/// "..", absolute names and symbolic links on the way are refused.
class ArtefactFolder : public ArtefactWriter {
 public:
  ArtefactFolder(std::filesystem::path run_directory, std::string instance);
  Status write(std::string_view name, std::span<const std::byte> bytes) override;

 private:
  std::filesystem::path run_directory_;
  std::string instance_;
};

}  // namespace tolman::record
