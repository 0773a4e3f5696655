// SPDX-License-Identifier: BSD-3-Clause
// Encoded messages by number, on disk and within a limit: when it is reached, every second one
// goes.
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

  /// Keeps `message` under `number`; replaces what was there. Of a full spool every second message
  /// is dropped first, so that the oldest are the thinnest. False when it finds no room at all.
  bool store(std::int64_t number, const std::string& message);

  bool contains(std::int64_t number) const { return extents_.contains(number); }
  std::optional<std::string> at(std::int64_t number) const;
  /// The number of the newest message up to `number`.
  std::optional<std::int64_t> atOrBefore(std::int64_t number) const;

  std::size_t messages() const { return extents_.size(); }
  std::uint64_t bytes() const { return used_; }

 private:
  struct Extent {
    std::uint64_t offset;
    std::uint64_t size;  ///< of the message; it takes whole blocks
  };
  using Extents = std::map<std::int64_t, Extent>;
  Extents::iterator drop(Extents::iterator extent);
  void thin();

  TemporaryFile file_;
  std::uint64_t capacity_;
  std::uint64_t used_ = 0;
  std::uint64_t end_ = 0;
  bool full_ = false;  ///< the file system cannot take blocks back
  Extents extents_;
};

}  // namespace tolman::web_viewer
