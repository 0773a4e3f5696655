// SPDX-License-Identifier: BSD-3-Clause
// The kind of file at a path, and whether it can be read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::video {

enum class PathKind : std::uint8_t {
  File,    ///< a regular file, which can be read again
  Pipe,    ///< a named pipe that contains data
  Device,  ///< a camera
};

/// An open file descriptor, or none (-1).
class OpenFile {
 public:
  explicit OpenFile(int number = -1) : number_(number) {}
  ~OpenFile();
  OpenFile(OpenFile&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  OpenFile& operator=(OpenFile&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int get() const { return number_; }

 private:
  int number_;
};

/// The kind of a path that can be opened, otherwise a failure with the reason. For a named pipe it
/// waits until data are written, at most `patience_s`, and leaves it open, non-blocking, as `pipe`,
/// because data in a pipe can be read only once.
Result<PathKind> findKind(const std::filesystem::path& path, OpenFile& pipe,
                          const Cancellation& cancellation, double patience_s = 10);

}  // namespace tolman::video
