// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: metadata.yaml of a bag.
#include "input.hpp"
#include "metadata_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const std::string text(fuzz::asText({data, size}));
  std::size_t letters = 0;
  for (const std::string& name : ros_bag::filesInMetadata(text)) letters += name.size();
  fuzz::require(letters <= size, "names that do not stand in the text");
  return 0;
}
