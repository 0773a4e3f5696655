// SPDX-License-Identifier: BSD-3-Clause
// Atomic writing: a file has either its old or its new contents, never a part of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tolman/status.hpp"

namespace tolman::record {

/// Owns a file descriptor and closes it.
class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  ~FileDescriptor();
  FileDescriptor(FileDescriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }

 private:
  int number_;
};

/// Opens and locks a folder; the lock ends with the descriptor. The result is not open if another
/// process holds the lock, or if `folder` is not a folder.
FileDescriptor lockFolder(const std::filesystem::path& folder);

/// Whether the call waits until the bytes are on the disk, so that they survive a loss of power.
enum class Sync : std::uint8_t { Yes, No };

/// Writes `bytes` to a temporary file in the open `directory`, syncs it, and renames it to `name`.
/// `shown` names the file in messages. After a failure the old file is unchanged and the temporary
/// one is removed.
Status writeAtomicallyAt(const FileDescriptor& directory, const std::string& name,
                         std::span<const std::byte> bytes, const std::string& shown,
                         Sync sync = Sync::Yes);

/// The same by path; the folder must exist.
Status writeAtomically(const std::filesystem::path& file, std::string_view text,
                       Sync sync = Sync::Yes);

/// Whether the path is what the program prints to, as /dev/stdout is.
bool isStandardOutput(const std::filesystem::path& file);

/// For a file that the user chose: a pipe, a device or the standard output is written to, not
/// replaced; everything else as by writeAtomically(). A pipe that nobody reads is a failure.
Status writeOutput(const std::filesystem::path& file, std::string_view text);

}  // namespace tolman::record
