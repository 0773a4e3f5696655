// SPDX-License-Identifier: BSD-3-Clause
// The roles as the host calls them: guarded, and with every answer checked against the contract
// (right frame, right stamp, no NaN, order in time).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plugins/instance.hpp"
#include "tolman/roles.hpp"

namespace tolman::plugins {

/// Whether a view's template id is dense and known; `templates` so far, -1 when that is not known.
Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates);

/// Holds the instance; the rest is per role.
class Stage {
 public:
  explicit Stage(std::unique_ptr<Instance> instance) : instance_(std::move(instance)) {}
  Instance& instance() { return *instance_; }
  const Instance& instance() const { return *instance_; }

 protected:
  std::unique_ptr<Instance> instance_;
};

class SourceStage : public Stage {
 public:
  using Stage::Stage;
  Status info(SourceInfo& info);
  /// Checks that frames are dense from 0, stamps increase and images keep their size.
  Status next(Frame& frame);
  Status inspect(std::vector<Finding>& findings);
  /// Where the run stands after reset() (the defaults), or after a saved state was loaded.
  void expect(std::int64_t next_frame = 0, std::int64_t last_stamp_ns = 0);
  /// The host numbers this session's frames from here; the plugin still counts from 0.
  void startAt(std::int64_t first_frame) { first_frame_ = first_frame; }

 private:
  Status check(const Frame& frame) const;
  SourceInfo info_;
  std::int64_t first_frame_ = 0;
  std::int64_t next_frame_ = 0;  ///< as the plugin counts
  std::int64_t last_stamp_ns_ = 0;
};

class OdometryStage : public Stage {
 public:
  using Stage::Stage;
  Status track(const Frame& frame, Motion& motion);
  Status finish(std::vector<MotionRevision>& revisions);
  /// As SourceStage's: odometry begins anew in each session.
  void startAt(std::int64_t first_frame) { first_frame_ = first_frame; }

 private:
  Status track(Odometry& odometry, const Frame& frame, Motion& motion) const;
  std::int64_t first_frame_ = 0;
};

class PlaceStage : public Stage {
 public:
  using Stage::Stage;
  /// Constant after configure(); a throwing plugin counts as PlaceInput::Frame.
  PlaceInput input();
  /// Checks that template ids are dense and known.
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation);
  Status finish();
  /// How many templates there are after reset() (none); -1 after a saved state was loaded, or an
  /// answer was lost: the next new one tells.
  void expect(std::int64_t templates = 0) { templates_ = templates; }

 private:
  std::int64_t templates_ = 0;
};

class CellsStage : public Stage {
 public:
  using Stage::Stage;
  /// Checks that experience ids are dense and known, heading and confidence in their ranges.
  Status step(const Motion& motion, const PlaceObservation& observation, Decision& decision);
  Status finish();
  /// How many experiences there are after reset() (none), or after a saved state was loaded.
  void expect(std::int64_t experiences = 0) { experiences_ = experiences; }

 private:
  Status check(const Decision& decision) const;
  std::int64_t experiences_ = 0;
};

class MapStage : public Stage {
 public:
  using Stage::Stage;
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update);
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera);
  Status graph(MapGraph& graph);
  Status finish(const std::vector<MotionRevision>& revisions);
};

class ObserverStage : public Stage {
 public:
  using Stage::Stage;
  Status begin(const RunInfo& run);
  Status observe(const Snapshot& snapshot);
  Status finish(const MapGraph& graph);
};

}  // namespace tolman::plugins
