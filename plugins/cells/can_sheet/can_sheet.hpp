// SPDX-License-Identifier: BSD-3-Clause
// Cells `can_sheet`: grid modules as continuous attractors, unit by unit, on twisted tori. Motion
// moves their bumps; familiar views inject where they were first seen; a view that all modules
// agree with closes a loop.
#pragma once

#include <optional>

#include "parameters.hpp"
#include "sheet_state.hpp"
#include "tolman/plugin.hpp"

namespace tolman::can_sheet {

class CanSheet final : public Cells,
                       public ArraySource,
                       public ArrayDescriptions,
                       public StateKeeper {
 public:
  using Parameters = CanSheetParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status step(const Motion& motion, const PlaceObservation& observation,
              Decision& decision) override;
  /// hd.activity {36}; grid.activity, grid2.activity ... {units, units}; position.decoded (x, y,
  /// heading).
  void arrays(std::vector<NamedArray>& arrays) const override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;
  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

  const SheetState& state() const { return *state_; }

 private:
  double periodOf(std::size_t module) const;
  /// The difference of phases of a displacement in m.
  Phase phaseOf(const Eigen::Vector2d& displacement, std::size_t module) const;
  void integrate(const Motion& motion, const Eigen::Vector2d& displacement);
  bool injects(const PlaceObservation& view) const;
  void inject(const ViewLink& link, const PlanarPose& seen, const Eigen::Vector2d& displacement);
  Phase placeOf(const ViewLink& link, const PlanarPose& seen, std::size_t module) const;
  bool agrees(const ViewLink& link, const PlanarPose& seen) const;
  void decodePosition();
  void closeLoop(const PlaceObservation& view, Decision& decision);
  void decide(const PlaceObservation& view, bool novel, Decision& decision);
  void learn(std::int64_t template_id);

  Parameters parameters_;
  std::optional<AttractorSheet> at_rest_;
  std::optional<SheetState> state_;  ///< empty before configure()
};

}  // namespace tolman::can_sheet
