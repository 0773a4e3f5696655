// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a bag in an .mcap file. A visited message can be read again and is the same.
#include "bag_reading.hpp"
#include "file_bytes.hpp"
#include "mcap_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  auto bytes = ros_bag::FileBytes::open(file.path());
  if (!bytes.isOk() || !ros_bag::McapFile::isMcap(bytes.value())) return 0;
  ros_bag::McapFile bag(std::move(bytes).value());
  fuzz::readMessages(bag, true);
  return 0;
}
