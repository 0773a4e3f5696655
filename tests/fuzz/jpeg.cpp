// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: JPEG images, grey and coloured.
#include "decode.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tolman::fuzz::decode({data, size});
  return 0;
}
