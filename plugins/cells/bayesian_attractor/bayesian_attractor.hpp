// SPDX-License-Identifier: BSD-3-Clause
// Cells `bayesian_attractor`: a network of head direction and grid cells. Its bumps of activity
// are competing hypotheses of the pose; from them the plugin decides at each frame: stay, create an
// experience, or close a loop.
#pragma once

#include <optional>

#include "parameters.hpp"
#include "saved_state.hpp"
#include "tolman/plugin.hpp"

namespace tolman::bayesian_attractor {

class BayesianAttractor final : public Cells,
                                public ArraySource,
                                public ArrayDescriptions,
                                public Localiser {
 public:
  using Parameters = AttractorParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override;
  void arrays(std::vector<NamedArray>& arrays) const override;

  Status describe(std::vector<ArrayInfo>& arrays) const override;
  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

  const AttractorState& state() const { return *state_; }

 private:
  AttractorState freshState() const;
  void integrate(const Motion& motion);
  LevelStep levelled(const Eigen::Isometry3d& T_from_to, const Matrix6d& covariance,
                     const Eigen::Vector3d& up_from) const;
  struct SeenPose {
    Eigen::Isometry3d T_template_current = Eigen::Isometry3d::Identity();
    Matrix6d covariance = Matrix6d::Zero();
  };
  SeenPose seenPose(const PlaceObservation& view) const;
  bool isAmbiguous(const std::vector<ViewLink>& links, const ViewLink& link) const;
  const ViewLink* nearestStorey(std::int64_t template_id, const Climb& climb) const;
  /// The link whose pattern a view injected at, and the outcome of the injection.
  struct Perception {
    Recalibration calibrated;
    const ViewLink* link = nullptr;
  };
  Perception perceive(const PlaceObservation& view, std::int64_t frame);
  LevelStep offsetOf(const SeenPose& seen) const;
  Recalibration injectView(const SeenPose& seen, const ViewLink& link, std::int64_t frame);
  void closeLoop(const PlaceObservation& view, const ViewLink& link, double share,
                 Decision& decision);
  void learn(std::int64_t template_id, const SeenPose& seen);
  void localise(const PlaceObservation& view, const Perception& perceived, Decision& decision);
  void followKnownPlace(const Motion& motion);
  bool knowsPlace() const;

  Parameters parameters_;
  bool localises_ = false;
  std::optional<AttractorState> state_;  ///< empty before configure()
};

}  // namespace tolman::bayesian_attractor
