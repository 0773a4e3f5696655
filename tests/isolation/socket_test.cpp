// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>

#include <catch2/catch.hpp>
#include <thread>

#include "isolation/channel.hpp"

using namespace tolman::isolation;
using std::chrono::milliseconds;

TEST_CASE("notes arrive whole, in order, with their text") {
  const auto [here, there] = Socket::pair();
  CHECK(there.send({7, 2, 1234567890123, "a line\nof text"}));
  CHECK(there.send({8, 0, 0, ""}));
  Note note;
  REQUIRE(here.receive(note, milliseconds(1000)) == Wait::Note);
  CHECK(note.kind == 7);
  CHECK(note.detail == 2);
  CHECK(note.size == 1234567890123);
  CHECK(note.text == "a line\nof text");
  REQUIRE(here.receive(note, milliseconds(1000)) == Wait::Note);
  CHECK(note.kind == 8);
  CHECK(note.text.empty());
}

TEST_CASE("a text that is too long is cut") {
  const auto [here, there] = Socket::pair();
  CHECK(there.send({1, 0, 0, std::string(3 * kMostText, 'x')}));
  Note note;
  REQUIRE(here.receive(note, milliseconds(1000)) == Wait::Note);
  CHECK(note.text == std::string(kMostText, 'x'));
}

TEST_CASE("silence is Nothing, a closed end is Gone for both directions") {
  auto [here, there] = Socket::pair();
  Note note;
  CHECK(here.receive(note, milliseconds(1)) == Wait::Nothing);
  there.close();
  CHECK(here.receive(note, milliseconds(1000)) == Wait::Gone);
  CHECK_FALSE(here.send({1, 0, 0, ""}));  // and no SIGPIPE
}

TEST_CASE("bytes that are no note end the conversation") {
  const auto [here, there] = Socket::pair();
  CHECK(::send(there.descriptor(), "abc", 3, 0) == 3);
  Note note;
  CHECK(here.receive(note, milliseconds(1000)) == Wait::Gone);
}
