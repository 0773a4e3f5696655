// SPDX-License-Identifier: BSD-3-Clause
// Map `relaxation`: RatSLAM's experience map (Milford and Wyeth 2008). Odometry is accumulated
// since the last experience; each decision adds a link and relaxes the graph. All links are of
// equal weight and no loop is ever rejected. Lengths are metres, angles radians. With `height` it
// is NeuroSLAM's (Yu et al. 2019), which relaxes heights in the same way; up is the -y axis of the
// first camera.
#pragma once

#include <cstdint>
#include <vector>

#include "experience_graph.hpp"
#include "tolman/roles.hpp"

namespace tolman::relaxation {

struct Parameters {
  int sweeps = 20;          // RatSLAM's for St Lucia
  double correction = 0.5;  // RatSLAM's
  bool height = false;

  static constexpr auto declaration() {
    using P = Parameters;
    return parameters(parameter("sweeps", &P::sweeps)
                          .range(0, 10000)
                          .doc("Sweeps over all links after each decision."),
                      parameter("correction", &P::correction)
                          .range(0, 0.5)
                          .doc("Share of a disagreement that each end of a link takes up."),
                      parameter("height", &P::height)
                          .doc("Heights above the first camera are relaxed too: four degrees of "
                               "freedom, as in NeuroSLAM. Otherwise the map is planar."));
  }
};

class RelaxationMap final : public Map {
 public:
  using Parameters = relaxation::Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status update(const Motion& motion, const Decision& decision, MapUpdate& update) override;
  Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const override;
  Status graph(MapGraph& graph) const override;
  Status finish(const std::vector<MotionRevision>& revisions) override;

 private:
  struct PlacedFrame {
    std::int64_t frame = -1;
    std::int64_t experience = -1;
    PlanarPose relative_to_experience;
    double climbed = 0;  ///< m above the experience
  };
  struct Creation {
    std::int64_t frame = -1;
    std::int64_t template_id = -1;
  };
  Status check(const Motion& motion, const Decision& decision) const;
  void advance(const Motion& motion);
  void applyDecision(const Motion& motion, const Decision& decision);
  void arriveAt(std::int64_t experience, const PlanarPose& offset, std::int64_t stamp_ns);
  /// Converts a pose in the graph, whose origin moves, to T_world_camera.
  Eigen::Isometry3d inWorld(const PlanarPose& pose, double height) const;
  Eigen::Isometry3d poseInWorld(const PlacedFrame& placed) const;

  Parameters parameters_;
  ExperienceGraph experiences_;
  std::vector<Creation> creations_;
  std::vector<PlacedFrame> frames_;
  std::int64_t current_ = -1;
  PlanarPose accumulated_;  ///< motion since the current experience
  double climbed_ = 0;      ///< m, since the current experience
  Eigen::Isometry3d T_start_camera_ = Eigen::Isometry3d::Identity();  ///< by dead reckoning
  std::int64_t left_ns_ = 0;
  std::int64_t loops_ = 0;
  std::int64_t version_ = 0;
};

}  // namespace tolman::relaxation
