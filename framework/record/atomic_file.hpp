// SPDX-License-Identifier: BSD-3-Clause
// Writing files: atomically, so that a file has either its old or its new contents, to places that
// the user chose, and for plugins. And where a path leads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/file_descriptor.hpp"
#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::record {

using tolman::FileDescriptor;

/// Opens and locks a folder; the lock ends with the descriptor. The result is not open if another
/// process holds the lock, or if `folder` is not a folder.
FileDescriptor lockFolder(const std::filesystem::path& folder);

/// Whether the call waits until the bytes are on the disk, so that they survive a loss of power.
enum class Sync : std::uint8_t { Yes, No };

/// Writes a temporary file beside `file`, syncs it, and renames it; the folder must exist. After a
/// failure the old file is unchanged and the temporary one is removed.
Status writeAtomically(const std::filesystem::path& file, std::string_view bytes,
                       Sync sync = Sync::Yes);

/// Whether the path is what the program prints to, as /dev/stdout is.
bool isStandardOutput(const std::filesystem::path& file);

/// For a file that the user chose: a pipe, a device or the standard output is written to, not
/// replaced; everything else as by writeAtomically(). A pipe that nobody reads is a failure.
Status writeOutput(const std::filesystem::path& file, std::string_view bytes);

struct OutputFile {
  std::filesystem::path path;
  std::string bytes;
};

/// Writes all files by writeOutput(), up to the first failure.
Status writeOutputs(const std::vector<OutputFile>& files);

/// The one path of a file that need not exist: absolute, without dots, links followed.
std::filesystem::path truePath(const std::filesystem::path& path);

/// Whether `path`, which need not exist, is `folder` or lies in it; links are followed.
bool isInside(const std::filesystem::path& path, const std::filesystem::path& folder);

/// The artefacts of one plugin instance. Writes below <run>/artefacts/<instance>/ only: names with
/// ".." and absolute names are refused.
class ArtefactFolder : public ArtefactWriter {
 public:
  ArtefactFolder(std::filesystem::path run_directory, std::string instance)
      : run_directory_(std::move(run_directory)), instance_(std::move(instance)) {}
  Status write(std::string_view name, std::span<const std::byte> bytes) override;

 private:
  std::filesystem::path run_directory_;
  std::string instance_;
};

}  // namespace tolman::record
