// SPDX-License-Identifier: BSD-3-Clause
// Vectors for working memory that a correction of the map needs for a moment: its size is that of
// the map, and in the heap it would stay with the process between smaller blocks that live on.
// Large ones get pages of their own, which the system has back when they are freed.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace tolman::experience_map {

template <class T>
struct PageAllocator {
  using value_type = T;
  PageAllocator() = default;
  template <class U>
  PageAllocator(const PageAllocator<U>&) {
  }  // NOLINT(google-explicit-constructor): as allocators do

  T* allocate(std::size_t count) {
    if (isSmall(count)) return std::allocator<T>().allocate(count);
    void* pages = ::mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) throw std::bad_alloc();
    return static_cast<T*>(pages);
  }
  void deallocate(T* memory, std::size_t count) {
    if (isSmall(count)) return std::allocator<T>().deallocate(memory, count);
    ::munmap(memory, count * sizeof(T));
  }
  friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }

 private:
  /// Mapping pages costs more than it saves for less.
  static bool isSmall(std::size_t count) { return count < (std::size_t{1} << 17U) / sizeof(T); }
};

template <class T>
using PageVector = std::vector<T, PageAllocator<T>>;

}  // namespace tolman::experience_map
