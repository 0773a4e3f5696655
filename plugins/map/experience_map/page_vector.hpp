// SPDX-License-Identifier: BSD-3-Clause
// Vectors for the working memory of a correction of the map. It is large, as the map is, and needed
// only for a short time. On the heap smaller blocks that remain in use could keep it from being
// returned to the system. So large vectors get pages of their own, which are returned when they are
// freed.
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
  /// Less than 128 KiB: mapping pages costs more than it saves.
  static bool isSmall(std::size_t count) { return count < (std::size_t{1} << 17U) / sizeof(T); }
};

template <class T>
using PageVector = std::vector<T, PageAllocator<T>>;

}  // namespace tolman::experience_map
