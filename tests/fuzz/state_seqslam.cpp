// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `seqslam`, and images after it.
#include "seqslam.hpp"
#include "small_plugins.hpp"
#include "state.hpp"
#include "support/gray_images.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  static fuzz::Small<seqslam::SeqSlam> place(fuzz::smallSeqSlam());
  if (!fuzz::loadState(place.plugin, "TLMSEQSL", 2, {data, size}).isOk()) return 0;
  fuzz::checkSaved(place.plugin);
  RandomStream random(1);
  for (std::int64_t i = 9; i < 12; ++i) {
    Frame frame;
    frame.frame = i;
    frame.left = test::noise(16, 8, random);
    PlaceObservation observation;
    const Status status = place.plugin.observe(frame, nullptr, observation);
    fuzz::checkAnswer(status, observation);
  }
  return 0;
}
