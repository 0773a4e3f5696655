// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: times.txt, and a column of a table. Accepted times increase.
#include <algorithm>
#include <functional>

#include "input.hpp"
#include "text_file.hpp"
#include "times_and_poses.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  for (const char* column : {"", "time"}) {
    image_folders::Inspection inspection;
    const auto times = image_folders::readTimes(file.path(), column, inspection);
    image_folders::checkCount(file.path(), times.size(), 3, inspection);
    if (inspection.hasErrors()) continue;
    fuzz::require(
        std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end(),
        "accepted times that do not increase");
  }
  return 0;
}
