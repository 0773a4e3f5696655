// SPDX-License-Identifier: BSD-3-Clause
// The activity of some units of a recorded population at evenly spaced frames: bounded in size,
// however long the run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "evaluation/unit_scores.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"

namespace tolman::run {

/// Planar pose of the camera at one frame.
struct StampedPose {
  PlanarPose pose;
  std::int64_t stamp_ns = 0;
};
using StampedPoses = std::unordered_map<std::int64_t, StampedPose>;
StampedPoses stampedPosesOf(const evaluation::Trajectory& trajectory);

class SampledPopulation {
 public:
  /// Whether the array is a ring of headings or a sheet of grid cells: activity over one axis of
  /// angles, or over two periodic axes.
  static bool accepts(const ArrayInfo& info);

  /// Of a ring all units up to 72 are kept, of a sheet 36, evenly spaced.
  explicit SampledPopulation(const ArrayInfo& info);

  const ArrayInfo& info() const { return info_; }
  bool isRing() const { return info_.axes.size() == 1; }
  std::size_t size() const;  ///< of the whole population

  /// Ignores an array of another size.
  void add(std::int64_t frame, std::span<const float> activity);

  /// At the frames that have a pose.
  evaluation::RecordedUnits units(const StampedPoses& poses) const;
  /// From the first to the last of these, s.
  double seconds(const StampedPoses& poses) const;

 private:
  void dropEverySecond();

  ArrayInfo info_;
  std::vector<std::size_t> chosen_;
  std::vector<std::int64_t> frames_;
  std::vector<float> rates_;  ///< a row a frame, a column a chosen unit
  std::size_t seen_ = 0;
  std::size_t stride_ = 1;
};

}  // namespace tolman::run
