// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: a bag in a .db3 file. A visited message can be read again and is the same.
#include "bag_reading.hpp"
#include "sqlite_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::ScratchFolder folder;
  folder.write("bag.db3", fuzz::asText({data, size}));
  auto bytes = ros_bag::FileBytes::open(folder.path() / "bag.db3");
  if (!bytes.isOk() || !ros_bag::SqliteFile::isSqlite(bytes.value())) return 0;
  auto bag = ros_bag::SqliteFile::open(folder.path() / "bag.db3", std::move(bytes).value());
  if (bag.isOk()) fuzz::readMessages(*bag.value(), false);
  return 0;
}
