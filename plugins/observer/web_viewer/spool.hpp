// SPDX-License-Identifier: BSD-3-Clause
// A file without a name; the system deletes it when the process ends.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "container.hpp"
#include "history_row.hpp"

namespace tolman::web_viewer {

/// All functions throw std::system_error on failure.
class TemporaryFile {
 public:
  /// Creates the file in the folder for temporary files ($TMPDIR).
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::uint64_t offset, std::span<const char> bytes);
  void read(std::uint64_t offset, std::span<char> bytes) const;
  /// Frees the blocks; false if the file system does not support this.
  bool release(std::uint64_t offset, std::uint64_t size);

 private:
  int descriptor_ = -1;
};

// Encoded messages by number, in a temporary file of limited size. When it is full, every second
// message is dropped.

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

// All history rows of a run, in a temporary file: no row is dropped, and memory is constant.

class RowStore {
 public:
  /// `values`: whole rows, one after the other.
  void append(const std::vector<double>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    file_.write(size_ * rowBytes(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    size_ += values.size() / rowColumns().size();
  }
  std::size_t size() const { return size_; }

  /// At most `count` rows from `first` on, as the array "rows"; fewer at the end, none beyond it.
  PackedArray read(std::size_t first, std::size_t count) const {
    first = std::min(first, size_);
    count = std::min(count, size_ - first);
    std::string bytes(count * rowBytes(), '\0');
    file_.read(first * rowBytes(), bytes);
    return {"rows",
            ElementType::F64,
            {count, rowColumns().size()},
            std::make_shared<const std::string>(std::move(bytes))};
  }

 private:
  static std::size_t rowBytes() { return rowColumns().size() * sizeof(double); }

  TemporaryFile file_;
  std::size_t size_ = 0;
};

}  // namespace tolman::web_viewer
