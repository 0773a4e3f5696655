// SPDX-License-Identifier: BSD-3-Clause
// Files that are either the old or the new one, never half of it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tolman/status.hpp"

namespace tolman::record {

/// A file descriptor with an owner.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept;
  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }

 private:
  int number_;
};

/// Writes `bytes` to a temporary file beside `name` in the open `directory`, syncs, renames.
/// `shown` names the file in messages. A failure leaves the old file and no temporary one.
Status writeAtomicallyAt(const Descriptor& directory, const std::string& name,
                         std::span<const std::byte> bytes, const std::string& shown);

/// The same by path; the folder must exist.
Status writeAtomically(const std::filesystem::path& file, std::string_view text);

}  // namespace tolman::record
