// SPDX-License-Identifier: BSD-3-Clause
// Whether the lengths of all motions that a map is made of have one unit: metres, or that of a
// single camera (Motion::scale_known).
#pragma once

#include <optional>
#include <string>

#include "tolman/records.hpp"

namespace tolman::pipeline {

/// The lengths of a map, as its last tracked motion gave them.
struct MapScale {
  bool is_known = true;  ///< metres
  std::string session;   ///< the earlier run that gave them; empty: the session itself
};

class ScaleCheck {
 public:
  /// `scale`: of the frames before the first one that is checked.
  void startFrom(MapScale scale) { scale_ = std::move(scale); }

  /// A change of the unit of lengths.
  struct Change {
    std::string text;
    bool ends_run = false;  ///< the map that is continued has lengths of the other kind
  };
  /// Call it with each motion, in order. Only tracked motions are compared: others have no lengths,
  /// or are predicted.
  std::optional<Change> check(const Motion& motion);

 private:
  std::optional<MapScale> scale_;  ///< none: nothing was tracked so far
};

}  // namespace tolman::pipeline
