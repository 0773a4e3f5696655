// SPDX-License-Identifier: BSD-3-Clause
// The records that the stages exchange: plain data, immutable once published.
//
// Times are those of the data, in integer nanoseconds. Results do not depend on the wall clock,
// with two exceptions: which frames `realtime` drops or leaves without place recognition, and calls
// that exceed the deadline of an isolated stage. A source numbers its frames 0, 1, 2 ...; under
// `realtime` later stages may not get some of them, and in a continued run the numbers follow those
// of the earlier run. A stage answers each frame that it is given exactly once; records of a frame
// are joined by index, never by time. World coordinates are those of the left camera at frame 0
// (x right, y down, z forward). 6x6 covariances have the order (translation, rotation), so their
// units are m^2, m rad and rad^2. The covariance of a pose T_a_b is in the tangent space of b; for
// a motion that is the camera where it ends: T = T_estimate * expSe3(noise).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/camera.hpp"
#include "tolman/fields.hpp"
#include "tolman/geometry.hpp"
#include "tolman/image.hpp"

namespace tolman {

/// One exposure of the rig, from a source.
struct Frame {
  static constexpr const char* kRecord = "frame";
  std::int64_t frame = -1;         ///< 0, 1, 2 ... from a source
  std::int64_t stamp_ns = 0;       ///< strictly increasing
  std::int64_t source_index = -1;  ///< in the data set, before `first`, `step` and `order`
  Image left;   ///< empty: no image source, or an image that could not be read (see `defect`)
  Image right;  ///< empty for a single camera; of a pair, both images are empty or neither
  bool has_truth = false;
  Eigen::Isometry3d T_world_camera_truth = Eigen::Isometry3d::Identity();
  std::string defect;               ///< why an image is missing; empty for a sound frame
  std::vector<NamedArray> sensors;  ///< what else was measured, e.g. "gyroscope.yaw_rate" (rad/s)

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "index in the run: 0, 1, 2 ...");
    TOLMAN_FIELD(stamp_ns, "ns", "data time of the exposure");
    TOLMAN_FIELD(source_index, "", "index in the data set, before first, step and order");
    TOLMAN_FIELD(left, "", "image of the left (or only) camera");
    TOLMAN_FIELD(right, "", "image of the right camera");
    TOLMAN_FIELD(has_truth, "", "whether the true pose is known");
    TOLMAN_FIELD(T_world_camera_truth, "m", "true pose, camera to world");
    TOLMAN_FIELD(defect, "", "why an image is missing");
    TOLMAN_FIELD(sensors, "", "measurements beside the images");
  }
};

/// State of odometry at one frame. If a frame is Initialising and the one before it was not,
/// tracking has restarted at an unknown pose.
enum class TrackingState : std::uint8_t {
  Initialising,  ///< no motion known; T_previous_current is the identity
  Tracking,      ///< measured
  Lost,          ///< T_previous_current is a prediction, with a large covariance
};
inline constexpr std::array<std::string_view, 3> kTrackingStateNames = {"initialising", "tracking",
                                                                        "lost"};
constexpr std::span<const std::string_view> enumNames(TrackingState) { return kTrackingStateNames; }

/// A better value for the motion that arrived at an earlier frame; replaces the earlier value.
struct MotionRevision {
  static constexpr const char* kRecord = "motion_revision";
  std::int64_t frame = -1;  ///< the frame whose Motion is replaced
  Eigen::Isometry3d T_previous_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame whose motion is replaced");
    TOLMAN_FIELD(T_previous_current, "m", "motion from the frame before");
    TOLMAN_FIELD(covariance, "m^2, m rad, rad^2", "covariance, translation before rotation");
  }
};

/// Answer of odometry for one frame: the motion since the previous frame that odometry was given.
struct Motion {
  static constexpr const char* kRecord = "motion";
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  TrackingState state = TrackingState::Initialising;
  double dt = 0;  ///< s since the previous frame; 0 at frame 0
  Eigen::Isometry3d T_previous_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
  double v = 0;              ///< m/s in the x-z plane of the camera, negative when reversing
  double omega = 0;          ///< rad/s about the camera's up axis (-y), positive to the left
  bool scale_known = true;   ///< false (a single camera): lengths are in arbitrary units
  std::int64_t tracked = 0;  ///< number of measurements that the estimate is based on
  bool is_keyframe = false;
  std::int64_t points_frame = -1;  ///< the frame that `points` belong to; -1 for none
  /// A column for each point of frame points_frame: u, v (px), inverse depth (1/m), its variance.
  Eigen::Matrix<float, 4, Eigen::Dynamic> points;
  std::vector<MotionRevision> revisions;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame at which the motion ends");
    TOLMAN_FIELD(stamp_ns, "ns", "its data time");
    TOLMAN_FIELD(state, "", "tracking state");
    TOLMAN_FIELD(dt, "s", "time since the frame before");
    TOLMAN_FIELD(T_previous_current, "m", "motion from the frame before");
    TOLMAN_FIELD(covariance, "m^2, m rad, rad^2", "covariance, translation before rotation");
    TOLMAN_FIELD(v, "m/s", "speed in the plane, negative when reversing");
    TOLMAN_FIELD(omega, "rad/s", "turning rate, positive to the left");
    TOLMAN_FIELD(scale_known, "", "whether lengths are metres");
    TOLMAN_FIELD(tracked, "", "number of measurements that the estimate is based on");
    TOLMAN_FIELD(is_keyframe, "", "whether the odometry made this frame a keyframe");
    TOLMAN_FIELD(points_frame, "", "the frame that the points belong to, -1 for none");
    TOLMAN_FIELD(points, "px, px, 1/m, 1/m^2", "columns of u, v, inverse depth, its variance");
    TOLMAN_FIELD(revisions, "", "better values for earlier motions");
  }
};

/// Fills dt (s), v and omega of a motion from T_previous_current, as in the paper (arXiv
/// 2003.03091, velocity calculation), but with a negative v when reversing.
template <class = void>
void setPlanarVelocity(Motion& motion, double dt) {
  motion.dt = dt;
  const Eigen::Vector3d t = motion.T_previous_current.translation();
  const double distance = std::hypot(t.x(), t.z());
  motion.v = dt > 0 ? (t.z() < 0 ? -distance : distance) / dt : 0;
  motion.omega = dt > 0 ? toPlanar(motion.T_previous_current).theta / dt : 0;
}

enum class Recognition : std::uint8_t {
  None,      ///< no image, skipped, or a match that is not yet confirmed
  Novel,     ///< a new template was made of this view
  Familiar,  ///< the view matches an earlier template
};
inline constexpr std::array<std::string_view, 3> kRecognitionNames = {"none", "novel", "familiar"};
constexpr std::span<const std::string_view> enumNames(Recognition) { return kRecognitionNames; }

/// Answer of place recognition for one frame.
struct PlaceObservation {
  static constexpr const char* kRecord = "place";
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  Recognition recognition = Recognition::None;
  std::int64_t template_id = -1;  ///< consecutive from 0 in order of creation; -1 only with None
  double score = 0;  ///< distance to the best template, in the plugin's measure; small if alike
  double relative_yaw =
      0;  ///< rad in [-2 pi, 2 pi], heading now minus at the template, positive to the left
  bool has_relative_pose = false;
  Eigen::Isometry3d T_template_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
  std::vector<Candidate> candidates{};  ///< optional; best first, also where none is familiar

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame of the view");
    TOLMAN_FIELD(stamp_ns, "ns", "its data time");
    TOLMAN_FIELD(recognition, "", "none, novel or familiar");
    TOLMAN_FIELD(template_id, "",
                 "local view template: 0, 1, 2 ... as they were made, -1 for none");
    TOLMAN_FIELD(score, "", "distance to the best template, in the plugin's measure");
    TOLMAN_FIELD(relative_yaw, "rad", "heading now minus heading of the template");
    TOLMAN_FIELD(has_relative_pose, "", "whether T_template_current was measured");
    TOLMAN_FIELD(T_template_current, "m",
                 "pose of the camera, in the camera frame of the template");
    TOLMAN_FIELD(covariance, "m^2, m rad, rad^2", "covariance, translation before rotation");
    TOLMAN_FIELD(candidates, "", "places that were considered, best first");
  }
};

enum class Action : std::uint8_t {
  Stay,              ///< still at `experience`
  CreateExperience,  ///< `experience` is new, and the robot is at it
  CloseLoop,         ///< the robot is back at the earlier `experience`
};
inline constexpr std::array<std::string_view, 3> kActionNames = {"stay", "create_experience",
                                                                 "close_loop"};
constexpr std::span<const std::string_view> enumNames(Action) { return kActionNames; }

/// A loop that was seen at an earlier frame and is accepted only now.
struct EarlierLoop {
  static constexpr const char* kRecord = "earlier_loop";
  std::int64_t frame = -1;       ///< the frame at which the loop was seen
  std::int64_t experience = -1;  ///< the experience to which the robot had returned
  Eigen::Isometry3d T_experience_camera = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame at which the loop was seen");
    TOLMAN_FIELD(experience, "", "the experience to which the robot had returned");
    TOLMAN_FIELD(T_experience_camera, "m",
                 "pose of the camera at that frame, in the coordinates of the experience");
    TOLMAN_FIELD(covariance, "m^2, m rad, rad^2", "covariance, translation before rotation");
  }
};

/// Answer of the spatial cells for one frame.
///
/// - CreateExperience: `experience` is the next id, from 0. Until the first one is created, the
///   answer is Stay with experience -1.
/// - CloseLoop: `experience` is any existing id, including the current one. With
///   has_relative_pose the map takes T_experience_current and `covariance`; without, it takes the
///   position of the experience and a heading turned by relative_yaw, with a large covariance.
/// - Stay: `experience` is the one of the last decision; the relative fields are not read.
/// relative_yaw and T_experience_current refer to the experience: compose the observation's pose
/// relative to the template with the pose of the template relative to the experience.
///
/// Of a Localiser: at each frame whose place is known has_relative_pose is set, with `experience`,
/// T_experience_current and `covariance`: CloseLoop where a view has just said so, else Stay. Where
/// it is not known: Stay with experience -1.
struct Decision {
  static constexpr const char* kRecord = "decision";
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  Action action = Action::Stay;
  std::int64_t experience = -1;   ///< consecutive from 0 in order of creation; -1 before the first
  std::int64_t template_id = -1;  ///< the view that led to the decision; -1 for none
  double relative_yaw =
      0;  ///< rad in [-2 pi, 2 pi], heading now minus at `experience`, positive to the left
  bool has_relative_pose = false;
  Eigen::Isometry3d T_experience_current = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
  /// rad in [0, 2 pi), positive to the left, 0 at the first frame: the head direction estimate
  double heading = 0;
  double confidence = 1;  ///< in [0, 1]
  /// Loops of earlier frames, in frame order; allowed with any action. Cells may need several views
  /// before they accept a loop; these are the views before the last one. A map that cannot correct
  /// earlier poses may ignore them.
  std::vector<EarlierLoop> earlier{};
  std::vector<PlaceHypothesis> hypotheses{};  ///< optional; those that this frame changed

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame of the decision");
    TOLMAN_FIELD(stamp_ns, "ns", "its data time");
    TOLMAN_FIELD(action, "", "stay, create_experience or close_loop");
    TOLMAN_FIELD(experience, "", "the experience that the robot is at, -1 before the first");
    TOLMAN_FIELD(template_id, "", "the view that led to the decision, -1 for none");
    TOLMAN_FIELD(relative_yaw, "rad", "heading now minus heading at the experience");
    TOLMAN_FIELD(has_relative_pose, "", "whether T_experience_current was measured");
    TOLMAN_FIELD(T_experience_current, "m",
                 "pose of the camera, in the coordinates of the experience");
    TOLMAN_FIELD(covariance, "m^2, m rad, rad^2", "covariance, translation before rotation");
    TOLMAN_FIELD(heading, "rad", "head direction estimate");
    TOLMAN_FIELD(confidence, "", "of the decision, 0 to 1");
    TOLMAN_FIELD(earlier, "", "loops of earlier frames that are accepted only now");
    TOLMAN_FIELD(hypotheses, "", "hypotheses that the frame changed");
  }
};

/// A node of the experience map.
struct Experience {
  static constexpr const char* kRecord = "experience";
  std::int64_t id = -1;     ///< consecutive from 0 in order of creation
  std::int64_t frame = -1;  ///< the frame at which it was created
  std::int64_t template_id = -1;
  Eigen::Isometry3d T_world_experience = Eigen::Isometry3d::Identity();

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(id, "", "0, 1, 2 ... in the order of creation");
    TOLMAN_FIELD(frame, "", "the frame at which it was created");
    TOLMAN_FIELD(template_id, "", "its local view template, -1 for none");
    TOLMAN_FIELD(T_world_experience, "m", "corrected pose, camera axes");
  }
};

enum class LinkKind : std::uint8_t { Odometry, Loop };
inline constexpr std::array<std::string_view, 2> kLinkKindNames = {"odometry", "loop"};
constexpr std::span<const std::string_view> enumNames(LinkKind) { return kLinkKindNames; }

/// A spatial constraint between two experiences.
struct Link {
  static constexpr const char* kRecord = "link";
  std::int64_t id = -1;    ///< consecutive from 0 in order of creation
  std::int64_t from = -1;  ///< id of an experience
  std::int64_t to = -1;    ///< id of an experience
  LinkKind kind = LinkKind::Odometry;
  std::int64_t frame = -1;  ///< the frame at which it was created
  Eigen::Isometry3d T_from_to = Eigen::Isometry3d::Identity();
  Matrix6d covariance = Matrix6d::Zero();
  double duration = 0;  ///< s of data time between the two ends; 0 for a loop link
  double weight = 1;    ///< in [0, 1]: weight under the robust loss of the optimiser

  /// Deprecated since SDK 0.2: the map decides, see MapGraph::isRejected().
  bool isBelieved() const { return weight >= (kind == LinkKind::Loop ? 0.1 : 1e-6); }

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(id, "", "0, 1, 2 ... in the order of creation");
    TOLMAN_FIELD(from, "", "id of the experience at its start");
    TOLMAN_FIELD(to, "", "id of the experience at its end");
    TOLMAN_FIELD(kind, "", "odometry or loop");
    TOLMAN_FIELD(frame, "", "the frame at which it was created");
    TOLMAN_FIELD(T_from_to, "m", "pose of `to`, in the coordinates of `from`");
    TOLMAN_FIELD(covariance, "m^2, m rad, rad^2", "covariance, translation before rotation");
    TOLMAN_FIELD(duration, "s", "data time between the two ends, 0 for a loop link");
    TOLMAN_FIELD(weight, "", "weight under the robust loss of the optimiser, 0 to 1");
  }
};

/// Answer of the map for one frame.
struct MapUpdate {
  static constexpr const char* kRecord = "map_update";
  std::int64_t frame = -1;
  std::int64_t stamp_ns = 0;
  std::int64_t experience = -1;  ///< the experience to which this frame is attached
  Eigen::Isometry3d T_experience_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();  ///< current estimate
  std::int64_t version = 0;      ///< increases with every correction of earlier poses
  std::int64_t experiences = 0;  ///< number of them in the graph
  std::int64_t links = 0;        ///< number of all links, rejected ones included
  std::int64_t loops = 0;        ///< number of loop links, rejected ones included

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame of the answer");
    TOLMAN_FIELD(stamp_ns, "ns", "its data time");
    TOLMAN_FIELD(experience, "", "the experience that the frame is attached to");
    TOLMAN_FIELD(T_experience_camera, "m",
                 "pose of the camera, in the coordinates of that experience");
    TOLMAN_FIELD(T_world_camera, "m",
                 "pose of the camera in the world, as estimated at this frame");
    TOLMAN_FIELD(version, "", "number of the last correction of the map");
    TOLMAN_FIELD(experiences, "", "experiences in the graph");
    TOLMAN_FIELD(links, "", "all links in the graph, rejected ones included");
    TOLMAN_FIELD(loops, "", "loop links in the graph, rejected ones included");
  }
};

/// The whole experience graph at one version.
struct MapGraph {
  static constexpr const char* kRecord = "map_graph";
  std::int64_t version = 0;
  std::vector<Experience> experiences;  ///< experiences[i].id == i
  std::vector<Link> links;              ///< links[i].id == i
  /// Ascending ids of the loop links that the map has rejected as false. They remain in `links`;
  /// counts, exports and connected parts leave them out. A robust optimiser may still give them a
  /// small weight.
  std::vector<std::int64_t> rejected;
  /// Optional, one for each link: how far the map is from it, in standard deviations; -1 for a link
  /// without a residual.
  std::vector<double> residuals{};

  bool isRejected(const Link& link) const {
    return std::binary_search(rejected.begin(), rejected.end(), link.id);
  }

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(version, "", "number of the last correction of the map");
    TOLMAN_FIELD(experiences, "", "nodes, by id");
    TOLMAN_FIELD(links, "", "constraints, by id");
    TOLMAN_FIELD(rejected, "", "ids of the rejected loop links, ascending");
    TOLMAN_FIELD(residuals, "", "distance of the map from each link, standard deviations");
  }
};

/// Covariance of a motion that was predicted from the last velocity, `lost_frames` frames after the
/// last measured one. With each frame the standard deviations grow by 0.1 m plus 30 % of the length
/// of `motion`, and by 0.03 rad (1.7 degrees): rough values for a vehicle, not a fit to data.
template <class = void>
Matrix6d predictionCovariance(const Eigen::Isometry3d& motion, int lost_frames) {
  const double metres = lost_frames * (0.1 + 0.3 * motion.translation().norm());
  const double radians = lost_frames * 0.03;
  Vector6d sigma = Vector6d::Constant(radians);
  sigma.head<3>().setConstant(metres);
  return sigma.cwiseAbs2().asDiagonal();
}

/// Poses of recent frames of a keyframe odometry, and the motions that it reported for them.
///
/// Each frame is stored relative to a keyframe. When the odometry refines its keyframes, the frames
/// move with them. A motion that then differs from the one reported is returned once as a
/// revision, which holds the new motion. Poses are T_world_camera, in metres.
///
/// The history has no access to the odometry's window. Methods that need keyframes take a function
/// from the frame index of a keyframe to std::optional<Eigen::Isometry3d>: its present
/// T_world_keyframe, or nothing for a keyframe that has left the window.
///
/// At most kMaxFrames frames are kept, because a camera that stands still makes no keyframes and
/// removeOld() would then remove no frames. The class is a template only to save compile time in
/// files that do not use it; write MotionHistory<>.
template <class = void>
class MotionHistory {
 public:
  static constexpr std::size_t kMaxFrames = 500;

  void clear() { entries_.clear(); }
  bool empty() const { return entries_.empty(); }
  const Eigen::Isometry3d& lastPose() const { return entries_.back().T_world_camera; }

  /// Adds the newest frame, stored relative to the keyframe of frame index `keyframe`, whose
  /// present pose is the inverse of T_keyframe_world. Returns the motion from the frame that was
  /// added before, `dt` seconds ago; this motion counts as reported, with `covariance`.
  Eigen::Isometry3d add(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                        std::int64_t keyframe, const Eigen::Isometry3d& T_keyframe_world,
                        const Matrix6d& covariance, double dt = 1) {
    Entry entry{
        frame,         keyframe, dt, covariance, normalised(T_keyframe_world * T_world_camera),
        T_world_camera};
    if (!empty()) entry.reported = normalised(lastPose().inverse() * T_world_camera);
    entries_.push_back(entry);
    if (entries_.size() > kMaxFrames) entries_.pop_front();
    return entry.reported;
  }

  /// Records that the newest frame's motion was reported as the identity, because none was known.
  void setLastReportedIdentity() { entries_.back().reported.setIdentity(); }

  /// Recomputes the poses of all frames from the present poses of their keyframes.
  void followKeyframes(const auto& find_keyframe) {
    for (Entry& entry : entries_) {
      if (const auto T_world_keyframe = find_keyframe(entry.keyframe))
        entry.T_world_camera = normalised(*T_world_keyframe * entry.T_keyframe_camera);
    }
  }

  /// Replaces the poses of the frames from `first` on by steps of the screw motion from the frame
  /// before `first` to T_world_current, the pose of the frame that is about to be added, `dt`
  /// seconds after the last one. Steps are proportional to the time between frames: a frame without
  /// an image leaves a longer step. They are equal if no time passes.
  void interpolate(std::int64_t first, const Eigen::Isometry3d& T_world_current, double dt = 1) {
    std::size_t begin = 0;
    while (begin < entries_.size() && entries_[begin].frame < first) ++begin;
    if (begin == 0 || begin == entries_.size()) return;
    const Eigen::Isometry3d T_world_start = entries_[begin - 1].T_world_camera;
    const Vector6d whole = logSe3(T_world_start.inverse() * T_world_current);
    double whole_dt = std::fmax(dt, 0);
    for (std::size_t i = begin; i < entries_.size(); ++i) whole_dt += std::fmax(entries_[i].dt, 0);
    const auto steps = static_cast<double>(entries_.size() - begin + 1);
    double passed = 0;
    for (std::size_t i = begin; i < entries_.size(); ++i) {
      Entry& entry = entries_[i];
      passed += whole_dt > 0 ? std::fmax(entry.dt, 0) / whole_dt : 1 / steps;
      const Eigen::Isometry3d moved = normalised(T_world_start * expSe3(whole * passed));
      entry.T_keyframe_camera =
          normalised(entry.T_keyframe_camera * entry.T_world_camera.inverse() * moved);
      entry.T_world_camera = moved;
    }
  }

  /// Revisions of motions that changed by more than 1 mm or 0.01 mrad since they were reported.
  /// Smaller changes are left to removeOld() and finish(), so that each frame has few revisions.
  std::vector<MotionRevision> largeRevisions() { return collect(1e-3, 1e-5, entries_.size()); }

  /// Removes the oldest frames up to the first one whose keyframe is still in the window. Returns
  /// every revision that is outstanding for them.
  std::vector<MotionRevision> removeOld(const auto& find_keyframe) {
    std::size_t end = 0;
    while (end < entries_.size() && !find_keyframe(entries_[end].keyframe)) ++end;
    if (end == 0) return {};
    std::vector<MotionRevision> revisions = collect(0, 0, end);
    // Keeps the last of them, because the motion of the next frame starts at its pose.
    entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(end) - 1);
    return revisions;
  }

  /// Every revision that is outstanding.
  std::vector<MotionRevision> finish() { return collect(0, 0, entries_.size()); }

 private:
  struct Entry {
    std::int64_t frame = -1;
    std::int64_t keyframe = -1;  ///< frame index of the keyframe
    double dt = 1;               ///< s since the frame before
    Matrix6d covariance;         ///< of `reported`
    Eigen::Isometry3d T_keyframe_camera;
    Eigen::Isometry3d T_world_camera;
    Eigen::Isometry3d reported = Eigen::Isometry3d::Identity();  ///< motion from the frame before
  };

  /// Revisions of the motions of entries 1 to end - 1 that changed by more than `metres` or
  /// `radians`. They count as reported from then on.
  std::vector<MotionRevision> collect(double metres, double radians, std::size_t end) {
    constexpr double kRounding = 1e-9;  // m and rad: products of poses round to less
    std::vector<MotionRevision> revisions;
    for (std::size_t i = 1; i < end; ++i) {
      Entry& entry = entries_[i];
      const Eigen::Isometry3d motion =
          normalised(entries_[i - 1].T_world_camera.inverse() * entry.T_world_camera);
      const Eigen::Isometry3d change = entry.reported.inverse() * motion;
      const bool moved = change.translation().norm() > std::fmax(metres, kRounding);
      const bool turned = logSo3(change.linear()).norm() > std::fmax(radians, kRounding);
      if (!moved && !turned) continue;
      entry.reported = motion;
      revisions.push_back({entry.frame, motion, entry.covariance});
    }
    return revisions;
  }

  std::deque<Entry> entries_;  ///< oldest first; the motion of the first is final
};

}  // namespace tolman
