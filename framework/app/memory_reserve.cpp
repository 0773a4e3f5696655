// SPDX-License-Identifier: BSD-3-Clause
#include "app/memory_reserve.hpp"

#include <atomic>
#include <cstdlib>

namespace tolman::app {
namespace {

constexpr std::size_t kReserve = std::size_t{8} << 20U;  // bytes; chosen, not tuned

// The handler of the standard library takes no argument.
std::atomic<void*> reserve = nullptr;

void release() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

}  // namespace

MemoryReserve::MemoryReserve() : before_(std::set_new_handler(release)) {
  std::free(reserve.exchange(std::malloc(kReserve)));  // never touched: no memory of the machine
}

MemoryReserve::~MemoryReserve() {
  std::set_new_handler(before_);
  std::free(reserve.exchange(nullptr));
}

}  // namespace tolman::app
