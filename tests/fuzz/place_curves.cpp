// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: earlier measurements that `tolman bench places --beside` reads and draws.
#include "experiment/place_truth.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  const auto curve = experiment::placeCurveOf(file.path());
  if (!curve.isOk()) {
    fuzz::require(!curve.status().message().empty(), "refused without a message");
    return 0;
  }
  fuzz::require(experiment::placeCurvesFigure({curve.value()}).ends_with("</svg>\n"), "no figure");
  return 0;
}
