// SPDX-License-Identifier: BSD-3-Clause
// Finds the robot on the stored paths when it drives them in the opposite direction: compares the
// present structure, turned by 180 degrees, with stored grids, and adds up the cost along the path
// in decreasing order of views.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "path_cost.hpp"
#include "place_search.hpp"
#include "place_verifier.hpp"
#include "street_points.hpp"
#include "structure_grid.hpp"

namespace tolman::view_sequences {

class BackwardSearch {
 public:
  explicit BackwardSearch(const SearchSettings& settings);

  /// Adds a view; its index is the number of earlier views. `levels`: its structure, if any. Two
  /// successive views of the path share one grid, that of the first.
  void add(const std::optional<StructureLevels>& levels, double path, std::int64_t predecessor);
  void join(std::int64_t from, std::int64_t to) { cost_.join(from, to); }
  void beginPass();

  /// One step along the path. `query` is null without structure: all costs are then 0.
  void step(const StructureQuery* query, double path, double advance);
  /// The most probable place after a step.
  std::optional<PlaceCandidate> best() const;
  /// The grid of a view that has structure.
  StructureLevels levelsOf(std::int64_t view) const;
  std::int64_t size() const { return static_cast<std::int64_t>(paths_.size()); }

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader, std::int64_t views);

 private:
  bool hasOwnGrid(std::int64_t view) const;
  bool isAtEnd(std::int64_t view) const;
  void compareAll(const StructureQuery& query);
  std::int64_t grids() const { return static_cast<std::int64_t>(cells_.size()) / kCells; }
  std::span<const std::uint8_t, kCells> grid(std::int64_t index) const;

  SearchSettings settings_;
  PathCost cost_;
  std::vector<std::uint8_t> cells_;         ///< kCells for each grid
  std::vector<std::int32_t> grid_of_view_;  ///< -1: none
  std::vector<float> paths_;                ///< of each view, m
  std::int64_t candidates_ = 0;             ///< number of views that are not recent, the first ones
  std::vector<float> of_grids_;             ///< distances of the compared grids
  std::vector<float> distances_;            ///< standardised, of the views
};

// Recognises streets that are driven in the opposite direction, from the structure that a stereo
// pair measures along the path: joins its points, searches the stored grids, and measures the pose.

/// A stored view that the robot passes in the opposite direction.
struct BackwardPlace {
  std::int64_t view = -1;
  double probability = 0;
  Eigen::Isometry3d T_template_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
};

class BackwardPlaces {
 public:
  /// Does nothing unless `enabled`, or without a calibrated stereo pair.
  BackwardPlaces(const CameraRig& rig, bool enabled, const SearchSettings& settings)
      : stereo_(rig), enabled_(enabled), search_(settings) {}

  bool canMeasure() const { return enabled_ && stereo_.canMeasure(); }
  /// Called for every frame.
  void move(const Motion& motion);
  /// Called for every step along the path, after move().
  void step(const PathStep& step, const Frame& frame);
  /// The present view was stored.
  void add(double path, std::int64_t predecessor);
  void join(std::int64_t from, std::int64_t to);
  /// Called once after step(): the place that is passed in the opposite direction. It must have at
  /// least this probability, and its structure and a pose measured some metres ago must agree.
  std::optional<BackwardPlace> find(double probability);

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader, std::int64_t views);

 private:
  /// `query` turned by `yaw` (rad, positive to the left) before it was compared.
  struct TurnedFit {
    StructureFit fit;
    double yaw = 0;
  };
  TurnedFit bestFit(const StructureDeviation& stored) const;
  std::optional<BackwardPlace> located(const PlaceCandidate& candidate) const;

  StereoPoints stereo_;
  bool enabled_;
  BackwardSearch search_;
  StreetPoints street_;
  StructureMean mean_;
  std::optional<StructureLevels> current_;  ///< grid at the last step
  double path_ = 0;                         ///< m, at the last step
  std::vector<float> poses_;  ///< planar (m, m, rad), three for each view, since its pass began
  PoseAgreement agreement_;
};

}  // namespace tolman::view_sequences
