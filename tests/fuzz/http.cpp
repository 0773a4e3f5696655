// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: what a client of the viewer sends, from the first byte on.
#include "input.hpp"
#include "viewer_connection.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMost = 1U << 15U;
  if (size <= kMost) tolman::fuzz::connectAndSend(tolman::fuzz::asText({data, size}));
  return 0;
}
