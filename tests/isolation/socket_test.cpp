// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>

#include <catch2/catch.hpp>
#include <thread>

#include "host/child_process.hpp"

using namespace tolman::host;
using std::chrono::milliseconds;

TEST_CASE("messages arrive complete and in order, also long ones of several threads") {
  const auto [here, there] = Socket::pair();
  const std::string longer(std::size_t{3} << 20U, 'x');
  std::thread first([&] { CHECK(there.send({7, 2, longer})); });
  std::thread second([&] { CHECK(there.send({7, 2, longer})); });
  SocketMessage message;
  for (int i = 0; i < 2; ++i) {
    REQUIRE(here.receive(message, milliseconds(1000)) == ReceiveResult::Message);
    CHECK(message.kind == 7);
    CHECK(message.detail == 2);
    CHECK(message.bytes == longer);
  }
  first.join();
  second.join();
  CHECK(there.send({8, 0, ""}));
  REQUIRE(here.receive(message, milliseconds(1000)) == ReceiveResult::Message);
  CHECK(message.kind == 8);
  CHECK(message.bytes.empty());
}

TEST_CASE("a message of more bytes than allowed is refused") {
  const auto [here, there] = Socket::pair();
  CHECK(there.send({1, 0, "12345"}));
  SocketMessage message;
  CHECK_THROWS_AS(here.receive(message, milliseconds(1000), 4), std::domain_error);
}

TEST_CASE("without a message receive() times out; a closed end is reported in both directions") {
  auto [here, there] = Socket::pair();
  SocketMessage message;
  CHECK(here.receive(message, milliseconds(1)) == ReceiveResult::Timeout);
  there.close();
  CHECK(here.receive(message, milliseconds(1000)) == ReceiveResult::Closed);
  CHECK_FALSE(here.send({1, 0, ""}));  // and no SIGPIPE
}

TEST_CASE("a message that is cut off closes the connection") {
  auto [here, there] = Socket::pair();
  CHECK(::send(there.descriptor(), "abc", 3, 0) == 3);
  there.close();
  SocketMessage message;
  CHECK(here.receive(message, milliseconds(1000)) == ReceiveResult::Closed);
}
