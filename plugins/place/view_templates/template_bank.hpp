// SPDX-License-Identifier: BSD-3-Clause
// What is kept of templates: cells, and landmarks.
//
// Stores the templates as a structure of arrays: all cells in one contiguous buffer of fixed-point
// numbers, all means in another. Memory grows by amortised doubling.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "landmark_pose.hpp"
#include "tolman/records.hpp"
#include "tolman/state_stream.hpp"
#include "view_maker.hpp"

namespace tolman::view_templates {

/// A cell in fixed point: [0, 1] on 0 ... kOne. Fifteen bits, so that sums of differences are exact
/// integers (the same on every machine) and eight fit in a baseline vector register.
using FixedCell = std::int16_t;
inline constexpr int kOne = 32767;

FixedCell toFixed(float cell);

class TemplateBank {
 public:
  TemplateBank(int columns, int rows) : columns_(columns), rows_(rows) {}

  /// Stores a view; its id is the number of templates before it.
  std::int64_t add(const LocalView& view);
  std::int64_t size() const { return static_cast<std::int64_t>(means_.size()); }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t cellsPerTemplate() const { return static_cast<std::size_t>(columns_ * rows_); }

  std::span<const FixedCell> cells(std::int64_t id) const {
    return {cells_.data() + static_cast<std::size_t>(id) * cellsPerTemplate(), cellsPerTemplate()};
  }
  double mean(std::int64_t id) const { return means_[static_cast<std::size_t>(id)]; }

  std::span<const FixedCell> allCells() const { return cells_; }
  std::span<const double> allMeans() const { return means_; }
  void clear();
  /// Restores the values of allCells() and allMeans(); their sizes must agree.
  void restore(std::vector<FixedCell> cells, std::vector<double> means);

 private:
  int columns_;
  int rows_;
  std::vector<FixedCell> cells_;
  std::vector<double> means_;
};

// Stores the landmarks of all templates and measures the pose of a frame relative to a template.

/// For stereo pairs; without a right image a template has no landmarks.
class LandmarkMemory {
 public:
  LandmarkMemory(const CameraRig& rig, int corners, int least_agreeing)
      : rig_(rig), corners_(corners), least_(least_agreeing) {}

  /// Whether the rig can measure landmarks.
  bool hasStereo() const { return rig_.isStereo() && rig_.calibrated; }
  /// Invalidates the corners of the previous frame.
  void beginFrame() { has_corners_ = false; }
  /// Stores the landmarks of the next template.
  void add(const Frame& frame);
  std::size_t size() const { return templates_.size(); }
  /// Whether template `id` has enough landmarks to be recognised by them.
  bool hasEnough(std::int64_t id) const;
  /// Pose of the camera relative to template `id`; empty if too few landmarks agree.
  std::optional<landmarks::MeasuredPose> locate(const Frame& frame, std::int64_t id,
                                                landmarks::Agreement& agreement);

  void save(StateWriter& writer) const;
  /// False when the state is damaged.
  bool load(StateReader& reader);

 private:
  const landmarks::Corners& cornersOf(const Frame& frame);

  CameraRig rig_;
  int corners_;
  int least_;
  std::vector<landmarks::Landmarks> templates_;
  landmarks::Corners frame_corners_;  ///< of the current frame
  bool has_corners_ = false;          ///< whether frame_corners_ is up to date
};

}  // namespace tolman::view_templates
