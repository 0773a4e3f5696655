// SPDX-License-Identifier: BSD-3-Clause
// One row of numbers a frame: what the page's graphs are drawn from.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

struct RowColumn {
  std::string_view name;
  std::string_view unit;
};

inline constexpr std::size_t kColumns = 32;
extern const std::array<RowColumn, kColumns> kRowColumns;

/// NaN where a value is not known.
using HistoryRow = std::array<double, kColumns>;

/// Makes rows of the snapshots of one run, in order: chains the odometry, and moves the truth into
/// the same world, that of the camera at frame 0.
class RowMaker {
 public:
  HistoryRow next(const Snapshot& snapshot);

 private:
  Eigen::Isometry3d T_world_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d>
      T_world_truth_;  ///< from the world of the truth to that of the run
  bool begun_ = false;
};

}  // namespace tolman::web_viewer
