// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: the saved state of `view_templates`, and two frames after it.
#include <optional>

#include "small_plugins.hpp"
#include "state.hpp"
#include "support/street_scene.hpp"
#include "view_templates.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  using Place = fuzz::Small<view_templates::ViewTemplates>;
  static Place place(fuzz::smallTemplates(), test::streetRig());
  static const Frame frame = test::streetFrame(9, Eigen::Isometry3d::Identity());
  if (!fuzz::loadState(place.plugin, "TLMVIEWS", 2, {data, size}).isOk()) return 0;
  fuzz::checkSaved(place.plugin);
  for (int i = 0; i < 2; ++i) {
    PlaceObservation observation;
    const Status status = place.plugin.observe(frame, nullptr, observation);
    fuzz::checkAnswer(status, observation);
    std::vector<NamedArray> arrays;
    place.plugin.arrays(arrays);
  }
  return 0;
}
