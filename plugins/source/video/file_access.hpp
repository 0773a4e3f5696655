// SPDX-License-Identifier: BSD-3-Clause
// What a path leads to, and whether it can be read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include "tolman/status.hpp"

namespace tolman::video {

enum class PathKind : std::uint8_t {
  File,    ///< a regular file: can be read again
  Pipe,    ///< a named pipe, in which data are
  Device,  ///< a camera
};

/// An open file descriptor, or none (-1).
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int get() const { return number_; }

 private:
  int number_;
};

/// The kind of a path that can be opened; otherwise a failure that says why not. For a named pipe
/// it waits until something is written, at most `patience_s`, and leaves it open as `pipe`, for
/// what is written into it is there only once. It does not block.
Result<PathKind> findKind(const std::filesystem::path& path, Descriptor& pipe,
                          double patience_s = 10);

}  // namespace tolman::video
