// SPDX-License-Identifier: BSD-3-Clause
// Synthetic input for a plugin of any role: a camera drives circles in a textured room, and for
// each frame there is a valid record of every stage. Poses, depths and images are exact; motions
// have seeded noise. Faults of real data are applied to it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/geometry.hpp"
#include "tolman/image.hpp"
#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// A box-shaped room with six textured walls. Images and depths are computed by intersecting the
/// ray of each pixel with the walls, so they are exact. The camera moves on a circle to the left
/// and looks along the tangent.
class SyntheticRoom {
 public:
  static constexpr double kRadius = 3;  ///< m, of the circle

  explicit SyntheticRoom(std::uint64_t seed) : seed_(seed) {}

  /// Pose after `angle` rad of the circle, relative to the first pose.
  static Eigen::Isometry3d poseAt(double angle);

  /// Image of a camera `offset` m to the right of the rig's left camera.
  Image view(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig, double offset) const;

  /// Depth along the optical axis at a pixel, m.
  static double depth(const Eigen::Isometry3d& T_world_camera, const CameraRig& rig,
                      const Eigen::Vector2d& pixel);

 private:
  struct Hit {
    int wall;               ///< 0 ... 5
    Eigen::Vector3d point;  ///< m, in the room
    double distance;        ///< in units of the length of the ray
  };
  static Hit castRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray);
  /// Grey level of a wall at a point.
  double greyLevel(const Hit& hit) const;
  double noise(std::uint64_t wall, double u, double v) const;

  std::uint64_t seed_;
};

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
};

/// Images for roles that use them, more than one circle for roles that need loops.
SequenceOptions optionsFor(Role role, std::uint64_t seed);

InputSequence makeSequence(const SequenceOptions& options);

/// The first `count` inputs, without revisions at the end.
InputSequence shortened(InputSequence sequence, std::size_t count);

// Faults of real data. All are legal: a plugin must answer.

/// Some frames without images and with `defect`; the last two among them.
void removeImages(InputSequence& sequence);
/// Some frames with lost tracking, some with the default records of skipped stages.
void loseTracking(InputSequence& sequence);
/// Some frames left out, as under `realtime`.
void dropFrames(InputSequence& sequence);
/// The same pixels with a stride larger than the width.
void padRows(InputSequence& sequence);
/// All images alternately black and white.
void makeTextureless(InputSequence& sequence);

}  // namespace tolman::conformance
