// SPDX-License-Identifier: BSD-3-Clause
// The map of a run in which the robot is found without changing it: the answer of the map for each
// frame, from what the cells say (Localiser of the SDK).
#pragma once

#include <cstdint>

#include "tolman/records.hpp"

namespace tolman::engine {

class LocalisedMap {
 public:
  /// `first_frame`: the first frame that is not of the map.
  LocalisedMap(MapGraph graph, std::int64_t first_frame);

  /// With experience -1 the place is unknown: T_world_camera is then the last pose that was known,
  /// moved by odometry.
  MapUpdate update(const Motion& motion, const Decision& decision);
  std::int64_t firstFrame() const { return first_frame_; }

 private:
  MapGraph graph_;
  std::int64_t first_frame_;
  MapUpdate last_;
};

}  // namespace tolman::engine
