// SPDX-License-Identifier: BSD-3-Clause
// Verification of places by landmarks: their store, agreement of poses with odometry, and the
// verifier.
//
// Landmarks of stored views, in a file without a name that is removed with the plugin. Only their
// offsets are in memory, and only those of candidates are read.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "edge_patches.hpp"
#include "landmark_pose.hpp"
#include "landmarks.hpp"
#include "scratch_file.hpp"
#include "tolman/geometry.hpp"
#include "tolman/records.hpp"
#include "tolman/state_stream.hpp"
#include "tolman/status.hpp"

namespace tolman::view_sequences {

/// Landmarks with the edges around them, one patch for each.
struct StoredLandmarks {
  landmarks::Landmarks corners;
  std::vector<landmarks::EdgePatch> patches;
};

class LandmarkStore {
 public:
  /// `view` must be larger than that of all earlier calls.
  Status add(std::int64_t view, const StoredLandmarks& landmarks);
  /// The view with landmarks nearest to `view`, at most `reach` views away; at equal distance the
  /// older one.
  std::optional<std::int64_t> nearest(std::int64_t view, std::int64_t reach) const;
  /// The landmarks of a view that has some.
  Result<StoredLandmarks> read(std::int64_t view) const;

  /// Fails if the file cannot be read.
  Status save(StateWriter& writer) const;
  /// InvalidInput for damaged bytes.
  Status load(StateReader& reader, std::int64_t views);

 private:
  struct StoredView {
    std::int64_t view;
    std::int64_t offset;  ///< in the file
    std::int64_t count;   ///< of landmarks
  };

  Status append(std::int64_t view, std::int64_t count, const std::vector<std::uint8_t>& bytes);
  Result<std::vector<std::uint8_t>> bytesOf(const StoredView& entry) const;

  std::vector<StoredView> entries_;
  std::int64_t end_ = 0;
  ScratchFile file_;
};

// Consistency of measured poses with odometry: successive poses at the right place differ by the
// driven motion, those of chance matches do not.

class PoseAgreement {
 public:
  /// Adds a measurement at `path` m: `stored` is the pose in the odometry frame of the stored path,
  /// `driven` that by odometry since the pass began. True if one made 4 to 12 m earlier agrees.
  bool add(double path, const PlanarPose& stored, const PlanarPose& driven);
  void forget() { measured_.clear(); }

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  struct Measured {
    double path = 0;
    PlanarPose stored;
    PlanarPose driven;
  };

  std::deque<Measured> measured_;  ///< the oldest first
};

// Verifies places by landmarks: the corners with depth of a stored view must agree on a pose of the
// present view, otherwise it is another place.

struct VerifierSettings {
  int corners = 0;           ///< most corners that a view keeps; 0: no landmarks
  int least_agreeing = 20;   ///< landmarks
  std::int64_t spacing = 4;  ///< views from one that keeps landmarks to the next
};

class PlaceVerifier {
 public:
  PlaceVerifier(const CameraRig& rig, const VerifierSettings& settings)
      : rig_(rig), settings_(settings) {}

  /// Whether landmarks are enabled and the rig is a calibrated stereo pair.
  bool canMeasure() const { return settings_.corners > 0 && rig_.isStereo() && rig_.calibrated; }
  /// Sets the frame of the following calls. It must exist until the next call.
  void beginFrame(const Frame& frame);
  /// The frame was stored as `view`: keeps its landmarks, if they are due.
  Status store(std::int64_t view);
  /// A view with landmarks at `view` or next to it.
  std::optional<std::int64_t> viewNear(std::int64_t view) const;
  /// Pose of the frame relative to a view with landmarks; empty if too few agree.
  Result<std::optional<landmarks::MeasuredPose>> locate(std::int64_t view);
  /// The same by the edges around landmarks. They are also found under other illumination, but only
  /// from nearly the same direction.
  Result<std::optional<landmarks::MeasuredPose>> locateByEdges(std::int64_t view);

  /// Of the last call of locate().
  const landmarks::Agreement& agreement() const { return agreement_; }

  Status save(StateWriter& writer) const { return store_.save(writer); }
  Status load(StateReader& reader, std::int64_t views) { return store_.load(reader, views); }

 private:
  const landmarks::Corners& corners();
  const landmarks::EdgeMap& edges();
  std::optional<landmarks::MeasuredPose> poseByEdges(const StoredLandmarks& stored,
                                                     std::size_t step, int least, double share);

  CameraRig rig_;
  VerifierSettings settings_;
  LandmarkStore store_;
  const Frame* frame_ = nullptr;
  std::optional<landmarks::Corners> corners_;         ///< of the frame, computed when needed
  landmarks::EdgeMap edges_;                          ///< as corners_
  bool has_edges_ = false;                            ///< whether edges_ are of the frame
  std::optional<landmarks::EdgeSearch> edge_search_;  ///< as corners_
  landmarks::Agreement agreement_;
};

}  // namespace tolman::view_sequences
