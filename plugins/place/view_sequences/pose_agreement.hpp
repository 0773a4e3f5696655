// SPDX-License-Identifier: BSD-3-Clause
// Consistency of measured poses with odometry: successive poses at the right place differ by the
// driven motion, those of chance matches do not.
#pragma once

#include <deque>

#include "tolman/geometry.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

class PoseAgreement {
 public:
  /// Adds a measurement at `path` m: `stored` is the pose in the odometry frame of the stored path,
  /// `driven` that by odometry since the pass began. True if one made 4 to 12 m earlier agrees.
  bool add(double path, const PlanarPose& stored, const PlanarPose& driven);
  void forget() { measured_.clear(); }

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  struct Measured {
    double path = 0;
    PlanarPose stored;
    PlanarPose driven;
  };

  std::deque<Measured> measured_;  ///< the oldest first
};

}  // namespace tolman::view_sequences
