// SPDX-License-Identifier: BSD-3-Clause
// Cells `pose_cells`: RatSLAM's network of pose cells and its experience decision.
#pragma once

#include <activity_volume.hpp>
#include <experience_memory.hpp>
#include <optional>
#include <vector>

#include "habituating_views.hpp"
#include "parameters.hpp"
#include "tolman/plugin.hpp"

namespace tolman::pose_cells {

class PoseCells final : public Cells, public ArraySource, public ArrayDescriptions {
 public:
  using Parameters = PoseCellParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override;
  /// hd.activity {headings} and grid.activity {side, side}: sums over the other axes, peak 1; and
  /// pose.estimate (x, y, theta in cells).
  void arrays(std::vector<NamedArray>& arrays) const override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  struct State {
    ActivityVolume volume;
    HabituatingViews<CellPose> views;
    ExperienceMemory<CellPose> experiences;
    PlanarPose pending;  ///< m, rad: motion not yet applied to the packet, in its axes
    CellPose estimate;
  };

  void integrate(const Motion& motion);
  void inject(const HabituatingViews<CellPose>::Injection& injection, double turned);
  /// The cell reached from `place` by a motion.
  CellPose moved(const CellPose& place, const PlanarPose& motion) const;
  CellPose estimate() const;
  double headingCells(double angle) const;

  Parameters parameters_;
  std::vector<float> excitation_;
  std::vector<float> inhibition_;
  std::optional<State> state_;  ///< empty before configure()
};

}  // namespace tolman::pose_cells
