// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>

#include <catch2/catch.hpp>
#include <thread>

#include "host/channel.hpp"

using namespace tolman::host;
using std::chrono::milliseconds;

TEST_CASE("messages arrive complete, in order, with their text") {
  const auto [here, there] = Socket::pair();
  CHECK(there.send({7, 2, 1234567890123, "a line\nof text"}));
  CHECK(there.send({8, 0, 0, ""}));
  SocketMessage message;
  REQUIRE(here.receive(message, milliseconds(1000)) == ReceiveResult::Message);
  CHECK(message.kind == 7);
  CHECK(message.detail == 2);
  CHECK(message.size == 1234567890123);
  CHECK(message.text == "a line\nof text");
  REQUIRE(here.receive(message, milliseconds(1000)) == ReceiveResult::Message);
  CHECK(message.kind == 8);
  CHECK(message.text.empty());
}

TEST_CASE("a text that is too long is cut off") {
  const auto [here, there] = Socket::pair();
  CHECK(there.send({1, 0, 0, std::string(3 * kMaxText, 'x')}));
  SocketMessage message;
  REQUIRE(here.receive(message, milliseconds(1000)) == ReceiveResult::Message);
  CHECK(message.text == std::string(kMaxText, 'x'));
}

TEST_CASE("without a message receive() times out; a closed end is reported in both directions") {
  auto [here, there] = Socket::pair();
  SocketMessage message;
  CHECK(here.receive(message, milliseconds(1)) == ReceiveResult::Timeout);
  there.close();
  CHECK(here.receive(message, milliseconds(1000)) == ReceiveResult::Closed);
  CHECK_FALSE(here.send({1, 0, 0, ""}));  // and no SIGPIPE
}

TEST_CASE("bytes that are not a message close the connection") {
  const auto [here, there] = Socket::pair();
  CHECK(::send(there.descriptor(), "abc", 3, 0) == 3);
  SocketMessage message;
  CHECK(here.receive(message, milliseconds(1000)) == ReceiveResult::Closed);
}
