// SPDX-License-Identifier: BSD-3-Clause
// What the viewer keeps of one frame: copies of small things, shared pixels.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

struct Sighting {
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  Image left;
  Motion motion;  ///< without revisions
  PlaceObservation place;
  Decision decision;
  MapUpdate map;
  std::vector<NamedArray> cells;
  StageTimes times_ns{};
  bool has_motion = false;
  bool has_place = false;
  bool has_decision = false;
  bool has_map = false;

  /// Takes what the snapshot has; memory of the sighting before is used again.
  void take(const Snapshot& snapshot);
};

}  // namespace tolman::web_viewer
