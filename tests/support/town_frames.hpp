// SPDX-License-Identifier: BSD-3-Clause
// Stereo pairs of the built-in town with their true poses; tests that use it link
// tolman_source_town_objects.
#pragma once

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "support/context.hpp"
#include "town_source.hpp"

namespace tolman::test {

/// All frames that the parameters ask for, and the rig.
inline std::vector<Frame> townFrames(ParameterValues parameters, CameraRig& rig) {
  TestContext context(std::move(parameters));
  town::TownSource source;
  const Status status = source.configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  SourceInfo info;
  REQUIRE(source.info(info).isOk());
  rig = info.rig;
  std::vector<Frame> frames;
  for (Frame frame; source.next(frame).isOk(); frame = {}) frames.push_back(frame);
  return frames;
}

/// Frames `first` to `last` at half of KITTI's size.
inline std::vector<Frame> townFrames(std::int64_t first, std::int64_t last, CameraRig& rig) {
  return townFrames({{"scale", 0.5}, {"first", first}, {"last", last}}, rig);
}

}  // namespace tolman::test
