// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstring>

#include "host/channel.hpp"

using tolman::host::SharedBuffer;

TEST_CASE("growing keeps what was written") {
  SharedBuffer buffer("test");
  std::memcpy(buffer.reserve(6), "hello", 6);
  std::byte* grown = buffer.reserve(std::size_t{5} << 20U);
  CHECK(std::strcmp(reinterpret_cast<const char*>(grown), "hello") == 0);
  grown[(std::size_t{5} << 20U) - 1] = std::byte{7};  // the last byte is there
}

TEST_CASE("a second mapping of the memory reads what was written, also after growing") {
  SharedBuffer writer("test");
  SharedBuffer reader(::dup(writer.descriptor()));
  writer.reserve(10)[9] = std::byte{1};
  CHECK(reader.view(10)[9] == std::byte{1});
  constexpr std::size_t kFar = std::size_t{3} << 20U;
  writer.reserve(kFar)[kFar - 1] = std::byte{2};
  CHECK(reader.view(kFar)[kFar - 1] == std::byte{2});
}

TEST_CASE("a size larger than the memory is refused") {
  SharedBuffer writer("test");
  writer.reserve(10);
  SharedBuffer reader(::dup(writer.descriptor()));
  CHECK_THROWS_WITH(reader.view(std::size_t{1} << 40U), "a message longer than the shared memory");
}

TEST_CASE("the memory cannot shrink") {
  SharedBuffer buffer("test");
  buffer.reserve(4096);
  CHECK(::ftruncate(buffer.descriptor(), 0) == -1);
  CHECK(errno == EPERM);
}
