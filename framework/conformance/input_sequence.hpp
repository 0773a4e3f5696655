// SPDX-License-Identifier: BSD-3-Clause
// Synthetic input for a plugin of any role: a camera drives circles in a textured room, and for
// each frame there is a valid record of every stage. Poses, depths and images are exact; motions
// have seeded noise.
#pragma once

#include <optional>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// One frame and the valid records of all stages for it.
struct FrameInput {
  Frame frame;
  Motion motion;
  PlaceObservation place;
  Decision decision;
  MapUpdate map;
  std::vector<NamedArray> cells;
  std::optional<MapGraph> graph;  ///< only if the map changed at this frame
};

struct InputSequence {
  CameraRig rig;
  std::vector<FrameInput> inputs;
  std::vector<MotionRevision> last_revisions;
  MapGraph graph;
};

struct SequenceOptions {
  std::uint64_t seed = 1;
  int frames = 30;
  int turn = 72;       ///< frames per circle
  bool stops = false;  ///< the camera stands still in the second circle, and later reverses
  int width = 320;     ///< px
  int height = 120;    ///< px
  bool images = true;
  bool stereo = true;
  bool depth = false;  ///< a depth image of the left camera, the sensor array "depth.left"
  PixelFormat format = PixelFormat::Gray8;
};

/// Images for roles that use them, more than one circle for roles that need loops.
SequenceOptions optionsFor(Role role, std::uint64_t seed);

InputSequence makeSequence(const SequenceOptions& options);

/// The first `count` inputs, without revisions at the end.
InputSequence shortened(InputSequence sequence, std::size_t count);

}  // namespace tolman::conformance
