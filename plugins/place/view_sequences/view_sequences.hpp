// SPDX-License-Identifier: BSD-3-Clause
// Place recognition by sequences of views along the driven path. Each step of `spacing` metres
// compares the present view with the stored ones and adds up the cost along stored paths. A view is
// familiar if its best place is much more probable than all others, or if landmarks verify it; if
// no place is likely, the view is stored as novel; between the two the answer is `none`. Only past
// views are used. The score of the answer is the probability that the best place is wrong.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "backward_places.hpp"
#include "edge_grid.hpp"
#include "parameters.hpp"
#include "path_cost.hpp"
#include "place_search.hpp"
#include "place_verifier.hpp"
#include "tolman/plugin.hpp"

namespace tolman::view_sequences {

class ViewSequences final : public Place,
                            public ArraySource,
                            public ArrayDescriptions,
                            public Localiser {
 public:
  using Parameters = view_sequences::Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  PlaceInput input() const override { return PlaceInput::FrameAndMotion; }
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override;

  /// "view.current" and "view.template" (that of the last answer): strength of the edges, rows x
  /// columns.
  void arrays(std::vector<NamedArray>& arrays) const override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  /// Steps since an event that has not happened: more than any spacing.
  static constexpr std::int64_t kNever = 1'000'000;

  /// A stored view at the present place, with the measured pose, if any.
  struct VerifiedView {
    std::int64_t view = -1;
    std::optional<landmarks::MeasuredPose> pose;
  };

  Status processStep(const PathStep& step, const Frame& frame, const PackedView& view,
                     PlaceObservation& observation);
  Status answer(const PathStep& step, const ViewQuery& query, int image_width,
                PlaceObservation& observation);
  using Locate = Result<std::optional<landmarks::MeasuredPose>> (PlaceVerifier::*)(std::int64_t);
  void explain(const std::vector<PlaceCandidate>& found, PlaceObservation& observation) const;
  Result<std::optional<VerifiedView>> verified(const std::vector<PlaceCandidate>& candidates);
  Result<std::optional<VerifiedView>> verifiedBy(Locate locate,
                                                 const std::vector<PlaceCandidate>& candidates);
  Result<std::optional<VerifiedView>> measuredNearer(Locate locate, const VerifiedView& place);
  bool recogniseBackwards(PlaceObservation& observation);
  Status store(const PathStep& step, PlaceObservation& observation);
  void recognise(const VerifiedView& place, const ViewQuery& query, int image_width,
                 PlaceObservation& observation);
  double yawOf(double moved_left_cells, int image_width) const;
  std::vector<double> storedParameters() const;

  Parameters parameters_;
  bool localises_ = false;
  CameraRig rig_;
  std::unique_ptr<PathSteps> steps_;
  std::unique_ptr<PlaceSearch> search_;
  std::unique_ptr<PlaceVerifier> verifier_;
  std::unique_ptr<BackwardPlaces> backwards_;
  MeanView mean_;
  PackedView current_{};
  landmarks::Agreement agreement_;         ///< with the most probable place; for explanations
  std::int64_t at_ = -1;                   ///< stored view of the last answer in the present
                                           ///< direction; -1 after a break
  bool at_is_new_ = false;                 ///< whether the last answer stored it
  std::int64_t since_measured_ = kNever;   ///< steps since landmarks agreed
  std::int64_t since_backwards_ = kNever;  ///< steps since a backward recognition
};

}  // namespace tolman::view_sequences
