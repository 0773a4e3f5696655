// SPDX-License-Identifier: BSD-3-Clause
// Memory that two processes see. It grows and never shrinks (the kernel is told so): otherwise the
// process that reads could be killed by the one that writes.
#pragma once

#include <cstddef>
#include <string>

namespace tolman::isolation {

class SharedBuffer {
 public:
  /// Fresh and empty. Throws std::system_error.
  explicit SharedBuffer(const std::string& name);
  /// Takes over a descriptor that was inherited.
  explicit SharedBuffer(int descriptor) : descriptor_(descriptor) {}
  ~SharedBuffer();
  SharedBuffer(const SharedBuffer&) = delete;
  SharedBuffer& operator=(const SharedBuffer&) = delete;

  int descriptor() const { return descriptor_; }
  /// For the writer: at least `size` bytes, what was written before kept. May move.
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
