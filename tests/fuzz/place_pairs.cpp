// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the pairs of images that `tolman bench places` reads.
#include "experiment/bench.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  const auto truth = experiment::truthOfPairs(file.path());
  if (!truth.isOk()) {
    fuzz::require(!truth.status().message().empty(), "refused without a message");
    return 0;
  }
  for (const std::int64_t i : {INT64_MIN, std::int64_t{-1}, std::int64_t{0}, INT64_MAX}) {
    (void)truth.value().isFindable(i);
    (void)truth.value().isSame(i, 0);
  }
  return 0;
}
