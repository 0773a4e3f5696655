// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `place_replay`, and frames after it.
#include "place_replay.hpp"
#include "small_plugins.hpp"
#include "state.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  static fuzz::Small<place_replay::PlaceReplay> place(fuzz::smallReplay());
  if (!fuzz::loadState(place.plugin, "TLMPLRPL", 4, {data, size}).isOk()) return 0;
  fuzz::checkSaved(place.plugin);
  for (std::int64_t i = 12; i < 24; ++i) {
    const Motion motion = fuzz::straightMotion(i);
    PlaceObservation observation;
    const Status status = place.plugin.observe(fuzz::loggedFrame(i), &motion, observation);
    fuzz::checkAnswer(status, observation);
  }
  return 0;
}
