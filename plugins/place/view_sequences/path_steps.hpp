// SPDX-License-Identifier: BSD-3-Clause
// Steps of equal length along the driven path, from the motions of odometry.
#pragma once

#include <cstdint>
#include <optional>

#include "tolman/records.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

struct PathStep {
  double path = 0;           ///< m driven so far, over all passes
  double advance = 1;        ///< length of this step, in spacings
  bool begins_pass = false;  ///< tracking (re)started at an unknown pose
};

class PathSteps {
 public:
  /// `gap` m are added to the path between two passes.
  PathSteps(double spacing, double gap) : spacing_(spacing), gap_(gap) {}

  /// Adds the frame's motion. Returns a step if the frame begins a pass, or if at least one spacing
  /// was driven since the last step. Lengths in unknown units are scaled so that a mean motion is
  /// one spacing.
  std::optional<PathStep> move(const Motion& motion);
  /// To be called if the image of a step's frame could not be used: the next frame repeats the
  /// step.
  void postpone(const PathStep& step);

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  double lengthOf(const Motion& motion);

  double spacing_;
  double gap_;
  double path_ = 0;
  double since_step_ = 0;
  double mean_length_ = 0;  ///< of motions in unknown units
  bool has_started_ = false;
  bool initialising_ = false;  ///< odometry had no motion at the previous frame
  bool pass_is_due_ = true;    ///< the next usable frame begins a pass
};

}  // namespace tolman::view_sequences
