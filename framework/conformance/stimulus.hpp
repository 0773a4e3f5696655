// SPDX-License-Identifier: BSD-3-Clause
// What a plugin of any role is shown: a seeded drive round a room, with everything that the stages
// before it would have said, and the ways in which reality spoils that.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// One frame with the sound answers of all stages.
struct Moment {
  Frame frame;
  Motion motion;
  PlaceObservation place;
  Decision decision;
  MapUpdate map;
  std::vector<NamedArray> cells;
  std::optional<MapGraph> graph;  ///< where the map changed
};

struct Stimulus {
  CameraRig rig;
  std::vector<Moment> moments;
  std::vector<MotionRevision> last_revisions;
  MapGraph graph;
};

struct StimulusOptions {
  std::uint64_t seed = 1;
  int frames = 30;
  int turn = 72;  ///< frames round the circle
  int width = 320;
  int height = 120;
  bool images = true;
  bool stereo = true;
  PixelFormat format = PixelFormat::Gray8;
};

/// Enough for the role: images where it looks at them, loops where it needs them.
StimulusOptions optionsFor(Role role, std::uint64_t seed);

Stimulus makeStimulus(const StimulusOptions& options);

/// The first `count` moments.
Stimulus shortened(Stimulus stimulus, std::size_t count);

// How reality spoils it. Legal: a plugin answers.
void loseImages(Stimulus& stimulus);  ///< some frames without images, with `defect`; two at the end
void loseTracking(Stimulus& stimulus);  ///< some frames with the stand-ins of skipped stages
void startBlind(Stimulus& stimulus);    ///< the first two frames with stand-ins
void dropFrames(Stimulus& stimulus);    ///< some frames left out, as under `realtime`
void padRows(Stimulus& stimulus);       ///< the same pixels with a stride beyond the width
void blind(Stimulus& stimulus);         ///< all pixels of one grey, nothing recognised

// Illegal: a plugin may refuse, and may not die.
void loseRightImages(Stimulus& stimulus);  ///< one camera where two were promised
void resizeImages(Stimulus& stimulus);     ///< images of another size than the rig's
void turnBackTime(Stimulus& stimulus);     ///< stamps that repeat and go back

}  // namespace tolman::conformance
