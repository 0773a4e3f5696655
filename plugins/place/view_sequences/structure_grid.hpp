// SPDX-License-Identifier: BSD-3-Clause
// Structure of a street: the number of points in each cell of a grid around the camera, 31.5 m
// across and 24 m along the street, in six bands of height. Seen in the opposite driving direction
// the same street has the same grid, turned by 180 degrees.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>

#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

/// Chosen on the town's `district`. A prototype found 64 % of the views that show a street in
/// the opposite direction there; with cells of 2.5 m 33 %, with three bands of height 36 %.
inline constexpr int kLateral = 21;
inline constexpr int kAlong = 16;
inline constexpr int kHeights = 6;
inline constexpr float kCellSize = 1.5F;  ///< m
inline constexpr int kSlice = kAlong * kHeights;
inline constexpr int kCells = kLateral * kSlice;

/// Logarithms of numbers of points, 0 to 15. Index (lateral * kAlong + along) * kHeights + height,
/// so that a shift to the side by a cell is a contiguous part.
using StructureLevels = std::array<std::uint8_t, kCells>;

/// Counts points, given in camera axes (m); those outside the grid are left out.
class StructureCounts {
 public:
  void add(const Eigen::Vector3f& point);
  StructureLevels levels() const;
  /// Points within the grid.
  std::int64_t points() const { return points_; }

 private:
  std::array<std::uint32_t, kCells> counts_{};
  std::int64_t points_ = 0;
};

/// Deviation of levels from a mean, in the order of the levels.
using StructureDeviation = std::array<float, kCells>;

/// The grid as a camera in the opposite direction at the same place would have it.
StructureDeviation turned(const StructureDeviation& deviation);

/// Mean of all grids so far. It is subtracted, because it contains no information about the place.
class StructureMean {
 public:
  void add(const StructureLevels& levels);
  const StructureDeviation& mean() const { return mean_; }
  StructureDeviation deviationOf(const StructureLevels& levels) const;

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  StructureDeviation mean_{};
  std::int64_t count_ = 0;
};

// The present structure, turned by 180 degrees, prepared for the comparison with stored grids.

/// Largest shift to either side, cells: the other lane is two or three cells away. Chosen on
/// district.
inline constexpr int kStructureShift = 5;

class StructureQuery {
 public:
  StructureQuery(const StructureLevels& levels, const StructureMean& mean);

  /// 1 - cosine between the deviations from the mean, where the grids overlap at the best shift to
  /// the side; 0 to 2.
  float distanceTo(std::span<const std::uint8_t, kCells> stored) const;

 private:
  static constexpr int kShifts = 2 * kStructureShift + 1;
  using Fixed = std::array<std::int16_t, kCells>;  ///< levels in units of 1 / 64

  Fixed query_;                                  ///< turned deviation
  Fixed mean_;                                   ///< of the stored grids
  std::array<float, kShifts> with_mean_;         ///< inner products of query and mean
  std::array<float, kShifts> norms_;             ///< of the query
  std::array<float, kLateral> squares_of_mean_;  ///< of each slice
};

/// Position of the present camera in the coordinates of a stored grid of the opposite direction.
struct StructureFit {
  double correlation = -1;  ///< cosine between the deviations
  double lateral = 0;       ///< m to the right of the stored camera
  double ahead = 0;         ///< m in front of the stored camera
  bool within = false;      ///< neither shift is the largest that was tried
};

/// Peak of the parabola through three values at -1, 0 and 1; the middle one is the largest.
double peakOf(double before, double at, double after);

/// Both are deviations from the mean; `query` is turned already.
StructureFit fitStructure(const StructureDeviation& query, const StructureDeviation& stored);

}  // namespace tolman::view_sequences
