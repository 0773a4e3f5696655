// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `bayesian_attractor`, and frames after it that see old and new
// views.
#include "bayesian_attractor.hpp"
#include "small_plugins.hpp"
#include "state.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  static fuzz::Small<bayesian_attractor::BayesianAttractor> cells({});
  if (!fuzz::loadState(cells.plugin, "TLMBAYES", 5, {data, size}).isOk()) return 0;
  fuzz::checkSaved(cells.plugin);
  for (std::int64_t i = 0; i < 12; ++i) {
    const bool old = i % 4 != 3;
    const PlaceObservation view =
        fuzz::seenView(100 + i, old ? Recognition::Familiar : Recognition::Novel, old ? i % 3 : i);
    Decision decision;
    const Status status = cells.plugin.step(fuzz::straightMotion(100 + i), view, decision);
    fuzz::checkAnswer(status, decision);
    std::vector<NamedArray> arrays;
    cells.plugin.arrays(arrays);
  }
  return 0;
}
