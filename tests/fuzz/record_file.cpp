// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: run.sqlite as a file of any bytes.
#include "edited_record.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::ScratchFolder folder;
  folder.write("run.sqlite", fuzz::asText({data, size}));
  fuzz::readEverything(folder.path());
  return 0;
}
