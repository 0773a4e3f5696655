// SPDX-License-Identifier: BSD-3-Clause
// Files that are either the old or the new one, never half of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tolman/status.hpp"

namespace tolman::record {

/// A file descriptor with an owner.
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

/// The open folder, locked against every other writer of it while it lives; not open when somebody
/// else holds the lock, or for what is no folder.
FileDescriptor lockFolder(const std::filesystem::path& folder);

/// Whether the bytes are on the disk when the call returns, so that they survive a loss of power.
enum class Sync : std::uint8_t { Yes, No };

/// Writes `bytes` to a temporary file beside `name` in the open `directory`, syncs, renames.
/// `shown` names the file in messages. A failure leaves the old file and no temporary one.
Status writeAtomicallyAt(const FileDescriptor& directory, const std::string& name,
                         std::span<const std::byte> bytes, const std::string& shown,
                         Sync sync = Sync::Yes);

/// The same by path; the folder must exist.
Status writeAtomically(const std::filesystem::path& file, std::string_view text,
                       Sync sync = Sync::Yes);

}  // namespace tolman::record
