// SPDX-License-Identifier: BSD-3-Clause
// The data of one frame until it is encoded. Pixels are shared, the rest is copied.
#pragma once

#include <vector>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

struct FrameCopy {
  std::int64_t frame = -1;
  Image left;
  std::int64_t points_frame = -1;                  ///< -1: no points
  Eigen::Matrix<float, 4, Eigen::Dynamic> points;  ///< as Motion::points
  std::vector<NamedArray> cells;

  /// Copies from the snapshot; reuses the memory of the previous copy.
  void assign(const Snapshot& snapshot) {
    frame = snapshot.frame->frame;
    left = snapshot.frame->left;
    points_frame = snapshot.motion != nullptr ? snapshot.motion->points_frame : -1;
    if (points_frame >= 0) points = snapshot.motion->points;
    if (snapshot.cells != nullptr) {
      cells = *snapshot.cells;
    } else {
      cells.clear();
    }
  }
};

}  // namespace tolman::web_viewer
