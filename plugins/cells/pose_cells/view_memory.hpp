// SPDX-License-Identifier: BSD-3-Clause
// Where in the volume each view was first seen, and how tired its cell is.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "activity_volume.hpp"

namespace tolman::pose_cells {

struct ViewSettings {
  double energy = 0.15;        ///< of a rested view
  double resting_decay = 1.0;  ///< and what an immediate repetition adds
  double restore = 0.04;       ///< per view
  int newest_ignored = 10;
};

class ViewMemory {
 public:
  explicit ViewMemory(const ViewSettings& settings) : settings_(settings) {}

  struct Injection {
    CellPose place;  ///< where the view was first seen
    double energy = 0;
  };
  /// One view: a new one is linked to `here`; a known one injects, unless it is too new or tired.
  std::optional<Injection> see(std::int64_t template_id, const CellPose& here);

 private:
  struct View {
    CellPose place;
    std::int64_t order = 0;
    double decay = 1;
    std::int64_t last_seen = 0;
  };

  ViewSettings settings_;
  std::map<std::int64_t, View> views_;
  std::int64_t seen_ = 0;
  std::int64_t previous_ = -1;
};

}  // namespace tolman::pose_cells
