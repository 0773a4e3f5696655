// SPDX-License-Identifier: BSD-3-Clause
// Cells `neuroslam_cells`: the two attractors of NeuroSLAM (Yu et al. 2019) and its decision.
#pragma once

#include <activity_volume.hpp>
#include <experience_memory.hpp>
#include <optional>
#include <vector>

#include "habituating_views.hpp"
#include "parameters.hpp"
#include "tolman/plugin.hpp"

namespace tolman::neuroslam_cells {

/// Place of both networks, in cells; each axis is periodic.
struct ConjunctivePlace {
  double x = 0;
  double y = 0;
  double height = 0;
  double heading = 0;
};

/// Shortest distance over all axes, in cells, of networks with so many cells along each side and
/// with so many headings.
double distance(const ConjunctivePlace& a, const ConjunctivePlace& b, double side, double headings);

class NeuroslamCells final : public Cells, public ArraySource, public ArrayDescriptions {
 public:
  using Parameters = neuroslam_cells::Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override;
  /// hd.activity {headings}, hd.layers {side, headings}, grid.activity {side, side} and grid.height
  /// {side}: sums over the other axes, peak 1; pose.estimate (x, y, height, heading in cells).
  void arrays(std::vector<NamedArray>& arrays) const override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  struct State {
    ActivityVolume head;  ///< heading, height
    ActivityVolume grid;  ///< x, y, height
    HabituatingViews<ConjunctivePlace> views;
    ExperienceMemory<ConjunctivePlace> experiences;
    /// By dead reckoning. Up is the -y axis of the first camera.
    Eigen::Isometry3d T_start_camera = Eigen::Isometry3d::Identity();
    ConjunctivePlace estimate = {};
  };

  void integrate(const Motion& motion);
  void inject(const HabituatingViews<ConjunctivePlace>::Injection& injection, double turned);
  ConjunctivePlace estimate() const;
  double headingCells(double angle) const;
  double radians(double heading) const;

  Parameters parameters_;
  std::vector<float> grid_excitation_;
  std::vector<float> grid_inhibition_;
  std::vector<float> head_excitation_;
  std::vector<float> head_inhibition_;
  std::optional<State> state_;  ///< empty before configure()
};

}  // namespace tolman::neuroslam_cells
