// SPDX-License-Identifier: BSD-3-Clause
// The recorded arrays of the spatial cells, sorted by their descriptions (ArrayInfo). Their size is
// bounded for runs of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "evaluation/unit_scores.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

/// Planar pose of the camera at one frame.
struct StampedPose {
  PlanarPose pose;
  std::int64_t stamp_ns = 0;
};
using StampedPoses = std::unordered_map<std::int64_t, StampedPose>;
/// Poses with a coordinate of 10,000 km and more are left out.
StampedPoses stampedPosesOf(const Trajectory& trajectory);

/// One array at evenly spaced frames.
struct PopulationHistory {
  ArrayInfo info;  ///< only the name is set if the array has no description
  std::vector<int> shape;
  std::vector<std::int64_t> frames;
  std::vector<std::vector<float>> activity;  ///< one row per frame, as large as the shape
  std::size_t stride = 1;                    ///< every stride-th array was kept
  std::size_t seen = 0;
  std::optional<std::vector<int>> given{};  ///< shape of the first array, whatever is described

  /// Keeps at most `most` arrays, and none of another shape.
  void add(std::int64_t frame, NamedArray&& array, std::size_t most);
};

struct CellHistory {
  std::vector<PopulationHistory> rings;   ///< head direction: activity over one axis of angles
  std::vector<PopulationHistory> sheets;  ///< grid modules: activity over two periodic axes
  std::vector<PopulationHistory> others;  ///< all other arrays, at no more than 240 frames

  CellHistory() = default;
  explicit CellHistory(const std::vector<ArrayInfo>& infos);
  /// The arrays of the cells, frame by frame.
  void add(std::int64_t frame, NamedArray&& array);
  /// Removes arrays that were described but not recorded.
  void dropEmpty();
  /// Why there is neither a ring nor a sheet: the first description that its array contradicts
  /// (cell_descriptions.hpp). Empty where there is one of them, nothing is contradicted, or no
  /// array was recorded. After the last add(), before dropEmpty().
  std::string whyUnscored() const;
};

inline constexpr int kMaxUnitsAlongAxis = 32;
/// Indices of the units that are measured, row by row: at most 72 of a ring and 32 by 32 of a
/// sheet, evenly spaced.
std::vector<std::size_t> measuredUnits(const PopulationHistory& population);

/// The activity of the units `chosen` at the frames that have a pose.
RecordedUnits unitsAt(const PopulationHistory& population, const StampedPoses& poses,
                      const std::vector<std::size_t>& chosen);

/// The period of a sheet, m; 0 if its unit is not m.
double periodInMetres(const PopulationHistory& sheet);

/// The value that index `i` of an axis stands for; in [0, period) for a periodic axis.
double axisValue(const ArrayAxis& axis, std::size_t i);
/// The same in radians, for an axis of angles in "deg" or "rad".
double axisAngle(const ArrayAxis& axis, std::size_t i);

/// What is wrong with the description of a population's array; empty if nothing is, or if it
/// describes no activity over axes. Asks for the arrays of the whole run.
std::string contradictionOf(const PopulationHistory& population);

}  // namespace tolman::evaluation
