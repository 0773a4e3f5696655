// SPDX-License-Identifier: BSD-3-Clause
// Cells `paper_attractor`: the network of arXiv:2003.03091 by its printed equations.
#pragma once

#include <experience_log.hpp>
#include <habituating_views.hpp>
#include <optional>
#include <vector>

#include "parameters.hpp"
#include "spatial_cells.hpp"
#include "tolman/plugin.hpp"

namespace tolman::paper_attractor {

/// What one view template was linked to when it was made.
struct ViewLink {
  CellPose learned;             ///< the estimate at that moment
  std::int64_t experience = 0;  ///< the experience the robot was at
  /// Pose of the template in the coordinates of that experience, by path integration.
  Eigen::Isometry3d T_experience_template = Eigen::Isometry3d::Identity();
};

class PaperAttractor final : public Cells, public ArraySource, public ArrayDescriptions {
 public:
  using Parameters = PaperAttractorParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override;
  void arrays(std::vector<NamedArray>& arrays) const override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  struct State {
    SpatialCells cells;
    HabituatingViews<ViewLink> links;
    ExperienceLog log;
    bool initialising = true;  ///< odometry had no motion yet
  };

  State freshState() const;
  void integrate(const Motion& motion);
  /// True when the view has injected energy.
  bool perceive(const Motion& motion, const PlaceObservation& observation);
  void closeLoop(const PlaceObservation& observation, const ViewLink& link, Decision& decision);
  void learn(std::int64_t template_id);

  Parameters parameters_;
  std::optional<State> state_;  ///< empty before configure()
};

}  // namespace tolman::paper_attractor
