// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the lines between the conformance kit and the process of a check. A plugin may write
// to the same descriptor.
#include "conformance/child.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman::conformance;
  const std::string text(tolman::fuzz::asText({data, size}));
  if (const auto message = decodeMessage(text)) {
    tolman::fuzz::require(decodeMessage(encode(*message)).has_value(),
                          "a message that cannot be read again");
  }
  return 0;
}
