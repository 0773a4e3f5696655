// SPDX-License-Identifier: BSD-3-Clause
// Recognises streets that are driven in the opposite direction, from the structure that a stereo
// pair measures along the path: joins its points, searches the stored grids, and measures the pose.
#pragma once

#include <cstdint>
#include <optional>

#include "backward_search.hpp"
#include "path_steps.hpp"
#include "pose_agreement.hpp"
#include "street_points.hpp"

namespace tolman::view_sequences {

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
