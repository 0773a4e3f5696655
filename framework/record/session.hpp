// SPDX-License-Identifier: BSD-3-Clause
// The sessions of a map's life: one run records its own frames after those of the runs that it
// goes on from.
#pragma once

#include <cstdint>
#include <string>

#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"

namespace tolman::record {

/// Frames of one source, in one go.
struct Session {
  static constexpr const char* kRecord = "session";
  std::int64_t id = 0;           ///< dense from 0; the last one is this run's own
  std::int64_t first_frame = 0;  ///< frames before it are of earlier sessions
  std::string name;              ///< of the run
  std::string source;            ///< what the source says of its data

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(id, "", "dense from 0; the last one is this run's own");
    TOLMAN_FIELD(first_frame, "", "its first frame; those before are of earlier sessions");
    TOLMAN_FIELD(name, "", "name of the run");
    TOLMAN_FIELD(source, "", "what the source says of its data");
  }
};

/// The last word of the map on one frame.
struct FinalPose {
  static constexpr const char* kRecord = "final_pose";
  std::int64_t frame = -1;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame");
    TOLMAN_FIELD(T_world_camera, "m", "pose in the world");
  }
};

}  // namespace tolman::record
