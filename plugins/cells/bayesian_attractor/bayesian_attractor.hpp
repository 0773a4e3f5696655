// SPDX-License-Identifier: BSD-3-Clause
// The plugin: one cycle of the Bayesian attractor network a frame, and its decision.
#pragma once

#include <optional>
#include <vector>

#include "attractor_state.hpp"
#include "parameters.hpp"
#include "tolman/plugin.hpp"

namespace tolman::bayesian_attractor {

class BayesianAttractor final : public Cells, public ArraySource, public StateKeeper {
 public:
  using Parameters = AttractorParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override;

  /// hd.activity {ring_units}, grid.activity {sheet_units, sheet_units}; hd.integrator,
  /// hd.calibration, hd.estimate, hd.injected as (mean rad, precision); the same of grid.* as
  /// (mean x, mean y in cells, precision). Further modules are grid2.*, grid3.* ... An injected
  /// precision of 0: none in this frame.
  void arrays(std::vector<NamedArray>& arrays) const override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  using State = AttractorState;
  enum class Effect : std::uint8_t { None, Injected, Relocated, RuledOut };

  State freshState() const;
  void integrate(const Motion& motion);
  void wakeUp();
  Effect perceive(const Motion& motion, const PlaceObservation& observation);
  Effect inject(const PlaceObservation& observation);
  bool inhibits(Recognition recognition, Effect effect) const;
  UncertainStep stepFromTemplate(const PlaceObservation& observation) const;
  double strengthOf(const PlaceObservation& observation, const PathMark& learned);
  bool relocates(const PlaceObservation& observation, const PathMark& learned);
  void relearn();
  void closeLoop(const PlaceObservation& observation, const ViewLink& link, Decision& decision);
  void learn(std::int64_t template_id);

  Parameters parameters_;
  std::optional<State> state_;  ///< empty before configure()
};

}  // namespace tolman::bayesian_attractor
