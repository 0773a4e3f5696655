// SPDX-License-Identifier: BSD-3-Clause
// Encoded messages by number, in a temporary file of limited size. When it is full, every second
// message is dropped.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "temporary_file.hpp"

namespace tolman::web_viewer {

class Spool {
 public:
  /// `capacity` in bytes on the disk.
  explicit Spool(std::uint64_t capacity) : capacity_(capacity) {}

  /// Stores `message` under `number`, replacing an older one. A full spool first drops every second
  /// message, so that old messages become sparse. False when there is no room at all.
  bool store(std::int64_t number, const std::string& message);

  std::optional<std::string> at(std::int64_t number) const;
  /// The number of the newest message up to `number`.
  std::optional<std::int64_t> atOrBefore(std::int64_t number) const;

  std::size_t messages() const { return extents_.size(); }
  std::uint64_t bytes() const { return used_; }

 private:
  struct Extent {
    std::uint64_t offset;
    std::uint64_t size;  ///< of the message in bytes; it occupies whole blocks
  };
  using Extents = std::map<std::int64_t, Extent>;
  Extents::iterator drop(Extents::iterator extent);
  void thin();

  TemporaryFile file_;
  std::uint64_t capacity_;
  std::uint64_t used_ = 0;
  std::uint64_t end_ = 0;
  bool full_ = false;  ///< the file system cannot free blocks
  Extents extents_;
};

}  // namespace tolman::web_viewer
