// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: every row of run.sqlite, for all readers of records. See edited_record.hpp.
#include "edited_record.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::ScratchFolder folder;
  fuzz::writeEditedRecord(folder.path(), fuzz::asText({data, size}));
  fuzz::readEverything(folder.path());
  return 0;
}
