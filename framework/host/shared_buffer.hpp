// SPDX-License-Identifier: BSD-3-Clause
// Memory shared by two processes. It can grow but not shrink (sealed by F_SEAL_SHRINK): otherwise
// the writer could truncate it, and reading would crash the reader.
#pragma once

#include <cstddef>
#include <string>

namespace tolman::isolation {

class SharedBuffer {
 public:
  /// Creates an empty buffer. Throws std::system_error.
  explicit SharedBuffer(const std::string& name);
  /// Takes ownership of an inherited descriptor.
  explicit SharedBuffer(int descriptor) : descriptor_(descriptor) {}
  ~SharedBuffer();
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  int descriptor() const { return descriptor_; }
  /// For the writer: at least `size` bytes; keeps what was written. May move the memory.
  std::byte* reserve(std::size_t size);
  /// For the reader: the first `size` bytes; throws std::runtime_error when there are fewer.
  const std::byte* view(std::size_t size);

 private:
  void map(std::size_t size);
  int descriptor_;
  std::byte* memory_ = nullptr;
  std::size_t mapped_ = 0;
};

}  // namespace tolman::isolation
