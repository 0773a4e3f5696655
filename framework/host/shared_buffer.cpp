// SPDX-License-Identifier: BSD-3-Clause
#include "host/shared_buffer.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

namespace tolman::isolation {
namespace {

constexpr std::size_t kStep = std::size_t{1} << 20U;  // bytes; each growth is a system call

[[noreturn]] void throwErrno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

std::size_t sizeOf(int descriptor) {
  struct stat state {};
  if (::fstat(descriptor, &state) != 0) throwErrno("the size of shared memory cannot be read");
  return static_cast<std::size_t>(state.st_size);
}

}  // namespace

SharedBuffer::SharedBuffer(const std::string& name)
    : descriptor_(::memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING)) {
  if (descriptor_ < 0) throwErrno("no shared memory");
  if (::fcntl(descriptor_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_SEAL) != 0) {
    ::close(descriptor_);
    throwErrno("shared memory cannot be sealed");
  }
}

SharedBuffer::~SharedBuffer() {
  if (memory_ != nullptr) ::munmap(memory_, mapped_);
  ::close(descriptor_);
}

void SharedBuffer::map(std::size_t size) {
  void* memory = memory_ == nullptr
                     ? ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0)
                     : ::mremap(memory_, mapped_, size, MREMAP_MAYMOVE);
  if (memory == MAP_FAILED) throwErrno("shared memory cannot be mapped");
  memory_ = static_cast<std::byte*>(memory);
  mapped_ = size;
}

std::byte* SharedBuffer::reserve(std::size_t size) {
  if (size <= mapped_) return memory_;
  // Grow by half, because a long list is written in many pieces.
  const std::size_t wanted = std::max(size, mapped_ + mapped_ / 2);
  const std::size_t rounded = (wanted + kStep - 1) / kStep * kStep;
  if (sizeOf(descriptor_) < rounded && ::ftruncate(descriptor_, static_cast<off_t>(rounded)) != 0) {
    throwErrno("shared memory cannot grow");
  }
  map(rounded);
  return memory_;
}

const std::byte* SharedBuffer::view(std::size_t size) {
  if (size <= mapped_) return memory_;
  const std::size_t there = sizeOf(descriptor_);
  if (there < size) throw std::runtime_error("a message longer than the shared memory");
  map(std::min(there, (size + kStep - 1) / kStep * kStep));
  return memory_;
}

}  // namespace tolman::isolation
