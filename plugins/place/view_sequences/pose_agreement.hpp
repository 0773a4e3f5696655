// SPDX-License-Identifier: BSD-3-Clause
// Poses that were measured on a stored path while driving: a chance match does not move along with
// odometry, the right place does.
#pragma once

#include <deque>

#include "tolman/geometry.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

class PoseAgreement {
 public:
  /// Measured at `path` m: `stored` in the frame in which the stored path was driven, `driven` by
  /// odometry since the pass began. Whether an earlier one, 4 to 12 m of path ago, agrees.
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
