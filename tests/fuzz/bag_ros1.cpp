// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a bag of ROS 1. A visited message can be read again and is the same.
#include "bag_reading.hpp"
#include "file_bytes.hpp"
#include "ros1_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  auto bytes = ros_bag::FileBytes::open(file.path());
  if (!bytes.isOk() || !ros_bag::Ros1File::isRos1(bytes.value())) return 0;
  auto bag = ros_bag::Ros1File::open(std::move(bytes).value());
  if (bag.isOk()) fuzz::readMessages(*bag.value(), true);
  return 0;
}
