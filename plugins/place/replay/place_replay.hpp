// SPDX-License-Identifier: BSD-3-Clause
// Place `place_replay`: recorded loop candidates as views of templates.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::place_replay {

struct ReplayParameters {
  int view_step = 5;
  bool relative_pose = false;
  double sigma_position = 1.0;
  double sigma_heading = 0.1;
  double kept = 1;
  double invented = 0;
  int invented_age = 100;

  static constexpr auto declaration() {
    using P = ReplayParameters;
    return parameters(
        parameter("view_step", &P::view_step)
            .range(1, 1000)
            .unit("frames")
            .doc("Frames of the data set from a look of the detector to its next one; where "
                 "candidates begin or end it looked anyway."),
        parameter("relative_pose", &P::relative_pose)
            .doc("Give the candidate's offset as a measured pose."),
        parameter("sigma_position", &P::sigma_position)
            .range(1e-3, 100)
            .unit("m")
            .doc("Reported standard deviation of that pose's position."),
        parameter("sigma_heading", &P::sigma_heading)
            .range(1e-4, 3)
            .unit("rad")
            .doc("Reported standard deviation of its heading."),
        parameter("kept", &P::kept)
            .range(0, 1)
            .doc("Share of the recorded candidates that are handed on."),
        parameter("invented", &P::invented)
            .range(0, 1)
            .doc("Share of the other frames at which any old view is claimed."),
        parameter("invented_age", &P::invented_age)
            .range(1, 1e9)
            .unit("frames")
            .doc("How old such a view is at least."));
  }
};

/// A candidate "frame i looks like frame j" is the template of j seen again at i. The detector
/// looks every few frames and where the source says so (`place.looked`). Each view that is not
/// recognised makes a template; one that is makes its own with the next frame, so that it can be
/// recognised, too.
class PlaceReplay final : public Place, public StateKeeper {
 public:
  using Parameters = ReplayParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  PlaceInput input() const override { return PlaceInput::FrameAndMotion; }
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  /// Where the view of a frame of the data set is kept.
  struct View {
    std::int64_t template_id = -1;
    PlanarPose in_template;  ///< where the frame was, seen from where the template was made
  };
  void forgetOtherDrives(const Frame& frame);
  void makeTemplate(std::int64_t source_index, const PlanarPose& in_template,
                    PlaceObservation& observation);
  bool isLook(const Frame& frame);
  bool recognise(const Frame& frame, PlaceObservation& observation);
  bool invent(const Frame& frame, PlaceObservation& observation);
  void claim(const View& view, const PlanarPose& here_in_earlier,
             PlaceObservation& observation) const;

  Status read(StateReader& reader);

  Parameters parameters_;
  std::uint64_t seed_ = 0;
  Logger* log_ = nullptr;
  RandomStream random_{0};
  std::map<std::int64_t, View> views_;  ///< by source index
  std::int64_t templates_ = 0;
  std::optional<float> drive_;             ///< whose frames the views are, as motion.drive says
  std::optional<std::int64_t> last_look_;  ///< source index
  std::optional<std::int64_t> owed_;       ///< source index of a recognised view without a template
};

}  // namespace tolman::place_replay
