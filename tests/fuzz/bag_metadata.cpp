// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: metadata.yaml of a bag.
#include "input.hpp"
#include "metadata_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const std::string text(fuzz::asText({data, size}));
  std::size_t letters = 0;
  const ros_bag::BagMetadata metadata = ros_bag::parseMetadata(text);
  for (const std::string& name : metadata.files) letters += name.size();
  for (const auto& [name, of] : metadata.topics) letters += name.size() + of.type.size();
  fuzz::require(letters <= size, "names that do not stand in the text");
  return 0;
}
