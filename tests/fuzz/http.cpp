// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the bytes of a client of the viewer, from the first one on.
#include "input.hpp"
#include "viewer_connection.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kMax = 1U << 15U;
  if (size <= kMax) tolman::fuzz::connectAndSend(tolman::fuzz::asText({data, size}));
  return 0;
}
