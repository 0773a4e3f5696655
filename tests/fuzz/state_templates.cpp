// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `view_templates`, and two frames after it.
#include <optional>

#include "small_plugins.hpp"
#include "state.hpp"
#include "support/street_scene.hpp"
#include "view_templates.hpp"

namespace {

using namespace tolman;

fuzz::Small<view_templates::ViewTemplates>& place() {
  static fuzz::Small<view_templates::ViewTemplates> instance(fuzz::smallTemplates(),
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
  if (!fuzz::loadState(place().plugin, "TLMVIEWS", 3, {data, size}).isOk()) return 0;
  fuzz::checkSaved(place().plugin);
  for (int i = 0; i < 2; ++i) {
    PlaceObservation observation;
    const Status status = place().plugin.observe(street(), nullptr, observation);
    fuzz::checkAnswer(status, observation);
    std::vector<NamedArray> arrays;
    place().plugin.arrays(arrays);
  }
  return 0;
}
