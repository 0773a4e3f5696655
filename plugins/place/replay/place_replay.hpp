// SPDX-License-Identifier: BSD-3-Clause
// Place `place_replay`: turns recorded loop candidates (sensor place.candidate) into template
// observations, or repeats those of a recorded run; poses in m and rad.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "recorded_answers.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::place_replay {

struct PlaceReplayParameters {
  std::string record;
  int view_step = 5;  // frames; the detector of the recorded candidates looked at every 5th
  bool relative_pose = false;
  double sigma_position = 1.0;  // m; chosen, not tuned; configs/motion.yaml has the measured one
  double sigma_heading = 0.1;   // rad; chosen, not tuned; as above
  double kept = 1;
  double invented = 0;
  int invented_age = 100;  // frames; chosen, not tuned
  int invented_run = 1;

  static constexpr auto declaration() {
    using P = PlaceReplayParameters;
    return parameters(
        parameter("record", &P::record)
            .path()
            .doc("Run directory, of a run with `record.replay: true`, whose observations are "
                 "repeated; the other parameters then have no effect. Empty: the candidates of the "
                 "source."),
        parameter("view_step", &P::view_step)
            .range(1, 1000)
            .unit("frames")
            .doc("Frames of the data set between two views that the detector compared; the ends of "
                 "candidates are always such views."),
        parameter("relative_pose", &P::relative_pose)
            .doc("Report the candidate's offset as a measured relative pose."),
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
            .doc("Share of the recorded candidates that are reported."),
        parameter("invented", &P::invented)
            .range(0, 1)
            .doc("Share of the other frames at which a false match with an old view is reported."),
        parameter("invented_age", &P::invented_age)
            .range(1, 1e9)
            .unit("frames")
            .doc("Smallest age of the view of a false match."),
        parameter("invented_run", &P::invented_run)
            .range(1, 1e6)
            .unit("views")
            .doc("False matches also come in runs of one to so many: the frames after the first "
                 "match the views after its view, as along two streets that look alike."));
  }
};

/// A candidate "frame i resembles frame j" becomes an observation of the template of j at frame i.
/// The recorded detector compared a frame every `view_step` frames and those that the source marks
/// (`place.looked`). A compared frame without candidate makes a template. After one with a
/// candidate the next frame makes its template, because a frame has only one observation; so later
/// frames can match it as well.
class PlaceReplay final : public Place, public Localiser {
 public:
  using Parameters = PlaceReplayParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  PlaceInput input() const override { return PlaceInput::FrameAndMotion; }
  Status observe(const Frame& frame, const Motion* motion, PlaceObservation& observation) override;

  Status save(std::ostream& stream) const override;
  Status load(std::istream& stream) override;

 private:
  /// The template of a frame of the data set.
  struct ReplayedView {
    std::int64_t template_id = -1;
    PlanarPose in_template;  ///< pose of the frame relative to the template
  };
  /// Removes the views when `motion.drive` changes: candidates are frame numbers, which are other
  /// places on another drive.
  void removeViewsOfOtherDrive(const Frame& frame);
  void makeTemplate(std::int64_t source_index, const PlanarPose& in_template,
                    PlaceObservation& observation);
  /// Whether the recorded detector compared this frame.
  bool isCompared(const Frame& frame);
  bool recognise(const Frame& frame, PlaceObservation& observation);
  /// Warns once of a frame whose candidates all name frames without a view.
  void warnOfLost(const Frame& frame);
  /// Reports a false match with an old view, or with the next one of a run of false matches.
  bool reportFalseMatch(const Frame& frame, PlaceObservation& observation);
  /// The view of a false match at this frame; empty for no false match.
  std::optional<ReplayedView> lookAlike(std::int64_t source_index);
  void reportMatch(const ReplayedView& view, const PlanarPose& here_in_earlier,
                   PlaceObservation& observation) const;

  Status read(StateReader& reader);

  Parameters parameters_;
  bool localises_ = false;
  std::uint64_t seed_ = 0;
  Logger* log_ = nullptr;
  recorded_answers::RecordedAnswers reader_;  ///< of `record`
  RandomStream random_{0};
  bool warned_of_lost_ = false;
  std::map<std::int64_t, ReplayedView> views_;  ///< by source index
  std::int64_t templates_ = 0;
  std::optional<float> drive_;                 ///< motion.drive of the views
  std::optional<std::int64_t> last_compared_;  ///< source index
  std::optional<std::int64_t>
      pending_;                  ///< source index of a recognised view that has no template yet
  std::int64_t run_end_ = -1;    ///< source index at which a run of false matches ends
  std::int64_t run_offset_ = 0;  ///< source index of the matched view minus that of the frame
};

}  // namespace tolman::place_replay
