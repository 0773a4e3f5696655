// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the bytes of a client of the viewer after a valid WebSocket handshake.
#include <string>

#include "input.hpp"
#include "viewer_connection.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMax = 1U << 15U;
  if (size > kMax) return 0;
  std::string bytes =
      "GET /live HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n";
  bytes += tolman::fuzz::asText({data, size});
  tolman::fuzz::connectAndSend(bytes);
  return 0;
}
