// SPDX-License-Identifier: BSD-3-Clause
// Stored messages are read back; a full spool drops every second one.
#include <catch2/catch.hpp>

#include "run_store.hpp"

namespace tolman::web_viewer {
namespace {

std::string message(std::int64_t number, std::size_t size) {
  return std::string(size, static_cast<char>('a' + number % 26)) + std::to_string(number);
}

}  // namespace

TEST_CASE("messages are read back unchanged") {
  Spool spool(1 << 20);
  CHECK_FALSE(spool.atOrBefore(5));
  for (const std::int64_t number : {3, 10, 12}) {
    REQUIRE(spool.store(number, message(number, 5000)));
  }
  CHECK(spool.at(10) == message(10, 5000));
  CHECK_FALSE(spool.at(11));
  CHECK_FALSE(spool.atOrBefore(2));
  CHECK(spool.atOrBefore(3) == 3);
  CHECK(spool.atOrBefore(11) == 10);
  CHECK(spool.atOrBefore(1000) == 12);
  REQUIRE(spool.store(10, "another"));
  CHECK(spool.at(10) == "another");
  CHECK(spool.messages() == 3);
}

TEST_CASE("a full spool keeps every second message, and the newest") {
  constexpr std::uint64_t kCapacity = 64 * 4096;
  Spool spool(kCapacity);
  for (std::int64_t number = 0; number < 1000; ++number) {
    REQUIRE(spool.store(number, message(number, 3000)));
    CHECK(spool.bytes() <= kCapacity);
    CHECK(spool.at(number).has_value());
  }
  CHECK(spool.at(0).has_value());
  CHECK(spool.messages() >= 32);
  std::int64_t last = 999;
  std::int64_t widest = 0;
  while (last > 0) {
    const std::int64_t before = *spool.atOrBefore(last - 1);
    CHECK(spool.at(before) == message(before, 3000));
    CHECK(last - before >= widest / 4);  // steps only grow towards the beginning
    widest = std::max(widest, last - before);
    last = before;
  }
}

TEST_CASE("a message larger than the spool is not stored") {
  Spool spool(8192);
  CHECK(spool.store(1, message(1, 4000)));
  CHECK_FALSE(spool.store(2, message(2, 9000)));
  CHECK(spool.at(1) == message(1, 4000));
  CHECK(spool.store(3, message(3, 8000)));  // all others make room
  CHECK(spool.messages() == 1);
}

TEST_CASE("rows are read back completely") {
  RowStore store;
  const std::size_t columns = rowColumns().size();
  CHECK(store.read(0, 10).shape == std::vector<std::size_t>{0, columns});
  for (int batch = 0; batch < 5; ++batch) {
    std::vector<double> rows;
    for (int i = 0; i < 3; ++i) rows.insert(rows.end(), columns, batch * 3 + i);
    store.append(rows);
  }
  CHECK(store.size() == 15);
  const PackedArray last = store.read(13, 100);
  CHECK(last.shape == std::vector<std::size_t>{2, columns});
  REQUIRE(last.bytes->size() == 2 * columns * sizeof(double));
  double value = 0;
  std::copy(last.bytes->end() - sizeof value, last.bytes->end(), reinterpret_cast<char*>(&value));
  CHECK(value == 14);
  CHECK(store.read(15, 1).bytes->empty());
  CHECK(store.read(SIZE_MAX, SIZE_MAX).bytes->empty());
}

}  // namespace tolman::web_viewer
