// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `view_sequences`, and steps after it.
#include "small_plugins.hpp"
#include "state.hpp"
#include "support/street_scene.hpp"
#include "view_sequences.hpp"

namespace {

using namespace tolman;

fuzz::Small<view_sequences::ViewSequences>& place() {
  static fuzz::Small<view_sequences::ViewSequences> instance(fuzz::smallSequences(),
                                                             test::streetRig());
  return instance;
}

const Frame& street() {
  static const Frame kFrame = test::streetFrame(9, Eigen::Isometry3d::Identity());
  return kFrame;
}

}  // namespace

/// Painting the street takes longer than any input may.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  place();
  street();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (!fuzz::loadState(place().plugin, "TLMVSEQS", 1, {data, size}).isOk()) return 0;
  fuzz::checkSaved(place().plugin);
  for (std::int64_t i = 9; i < 11; ++i) {
    Frame frame = street();
    frame.frame = i;
    const Motion motion = fuzz::straightMotion(i);
    PlaceObservation observation;
    const Status status = place().plugin.observe(frame, &motion, observation);
    fuzz::checkAnswer(status, observation);
    std::vector<NamedArray> arrays;
    place().plugin.arrays(arrays);
  }
  return 0;
}
