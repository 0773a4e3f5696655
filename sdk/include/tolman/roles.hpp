// SPDX-License-Identifier: BSD-3-Clause
// The six roles. A plugin implements one of these classes; the host calls it.
//
// Lifetime: construct (cheap: no files, no threads) -> configure -> work ... -> finish -> destroy.
//           reset() may come after configure at any time; the instance is then as if it had just
//           been configured: the same frames give the same answers, bit by bit.
// Threads:  one call at a time per instance, but not always from the same thread. A plugin may use
//           threads of its own (oneTBB) inside a call; none may run on after finish().
// Order:    frames come in order, frame.frame = 0, 1, 2 ...; under `realtime` some may be left out.
// Sessions: in a run that continues another (--continue), source and odometry count from 0 again;
//           place, cells and map start with their state at the end of that run (StateKeeper). For
//           them and for observers frame, template and experience ids continue. The first motion is
//           Initialising: the pose relative to the earlier session is unknown.
// Answers:  outputs are default-constructed records made by the host. Exactly one answer a frame:
//           copy frame and stamp_ns from the input, fill what you know.
// Failure:  return a Status, or throw std::exception. The configuration's `on_failure` decides what
//           follows: stop the run, skip the frame, or restart the plugin in a new process (only
//           with `isolation: process`). After a skipped frame the next call comes as usual;
//           later stages receive a substitute: a predicted motion (Lost), no observation, Stay.
//           T_previous_current is always the motion since the last frame that odometry was given.
//           The host refuses answers with NaN or infinity, numbers above 1e100, positions beyond
//           1e12 m, invalid rotations or covariances, and answers whose frame index or stamp
//           differs from the input's.
// Results:  of a plugin depend on inputs, parameters and seed alone, never on time, addresses or
//           thread count.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman {

enum class Role : std::uint8_t { Source, Odometry, Place, Cells, Map, Observer };
inline constexpr std::array<std::string_view, 6> kRoleNames = {"source", "odometry", "place",
                                                               "cells",  "map",      "observer"};
constexpr std::span<const std::string_view> enumNames(Role) { return kRoleNames; }

/// Base of all roles.
class Plugin {
 public:
  /// noexcept(false): the host catches exceptions of a destructor, and the process continues.
  virtual ~Plugin() noexcept(false) {}
  /// Takes parameters and services; called once. May open files and allocate. The message of a
  /// failure names the remedy.
  virtual Status configure(const Context& context) = 0;
  /// Back to the state right after configure().
  virtual Status reset() = 0;
};

/// Description of the data, given before the first frame.
struct SourceInfo {
  static constexpr const char* kRecord = "source_info";
  std::string description;  ///< one line for people: "KITTI odometry, 51 stereo pairs, ..."
  CameraRig rig;
  std::int64_t frames = -1;  ///< how many will come; -1 when not known
  bool has_truth = false;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(description, "", "one line for people");
    TOLMAN_FIELD(rig, "", "the cameras");
    TOLMAN_FIELD(frames, "", "how many will come, -1 when not known");
    TOLMAN_FIELD(has_truth, "", "whether frames come with their true poses");
  }
};

/// Gives frames in the order of time, and the rig that took them. configure() checks the data as
/// far as is possible without decoding them, so that findings (Context::findings) come before frame
/// 0: counts, calibration, times, truth.
class Source : public Plugin {
 public:
  virtual Status info(SourceInfo& info) = 0;
  /// Fills the next frame; Status::endOfStream() after the last. Where an image cannot be read, add
  /// an error to Context::findings and give a frame with empty images and `defect` set. stamp_ns
  /// increases strictly; all images have one size.
  virtual Status next(Frame& frame) = 0;
};

/// Estimates motion from images (or replays it).
class Odometry : public Plugin {
 public:
  /// The motion from the previous frame that odometry received to this one. At frame 0:
  /// Initialising, identity. Empty images are legal: answer Lost with a prediction. The motion may
  /// contain revisions of earlier motions; of several revisions of one frame the last is valid.
  virtual Status track(const Frame& frame, Motion& motion) = 0;
  /// After the last frame: all revisions that were not returned before.
  virtual Status finish(std::vector<MotionRevision>& revisions) = 0;
};

/// The input of a place recogniser besides the frame.
enum class PlaceInput : std::uint8_t {
  Frame,           ///< none; the plugin runs in parallel with odometry
  FrameAndMotion,  ///< the motion of the same frame, with its points; it runs after odometry
};

/// Visual place recognition.
class Place : public Plugin {
 public:
  /// Constant after configure().
  virtual PlaceInput input() const { return PlaceInput::Frame; }
  /// `motion` is null exactly when input() is Frame. An empty image is legal: answer None.
  virtual Status observe(const Frame& frame, const Motion* motion,
                         PlaceObservation& observation) = 0;
  virtual Status finish() { return Status::ok(); }
};

/// A model of head direction cells, grid cells or place cells. It decides where the robot is, and
/// gets no images. It may use motion.revisions or leave them to the map.
class Cells : public Plugin {
 public:
  virtual Status step(const Motion& motion, const PlaceObservation& observation,
                      Decision& decision) = 0;
  virtual Status finish() { return Status::ok(); }
};

/// Keeps the experience graph that the decisions of the cells define.
class Map : public Plugin {
 public:
  /// Applies the motion's revisions (ignoring those of frames it never saw), then its motion, then
  /// the decision; attaches the frame to an experience and estimates its pose. The first camera
  /// pose is the origin of the map, also for frames before the first experience.
  virtual Status update(const Motion& motion, const Decision& decision, MapUpdate& update) = 0;
  /// Pose of frame `frame`, as estimated now. InvalidParameter for a frame not seen.
  virtual Status poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const = 0;
  /// The whole graph, as estimated now.
  virtual Status graph(MapGraph& graph) const = 0;
  /// After the last frame: applies the last revisions and optimises once more.
  virtual Status finish(const std::vector<MotionRevision>& revisions) = 0;
};

/// An event that is not the answer of a stage: a skipped frame, lost tracking, a dropped frame.
struct RunEvent {
  static constexpr const char* kRecord = "run_event";
  std::int64_t frame = -1;  ///< -1: before the first or after the last
  LogLevel level = LogLevel::Info;
  std::string source;  ///< name of the stage
  std::string message;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "the frame that it happened at, -1 for none");
    TOLMAN_FIELD(level, "", "severity");
    TOLMAN_FIELD(source, "", "name of the stage");
    TOLMAN_FIELD(message, "", "for people");
  }
};

/// Wall time in ns that each role took for one frame, in the order of Role. For display only.
using StageTimes = std::array<std::int64_t, kRoleNames.size()>;

/// All records of one frame, for observers. No pointer is null unless said below. Pointers are
/// valid during the call only; copy what you keep. Records can be copied cheaply (images are
/// shared).
struct Snapshot {
  const Frame* frame = nullptr;
  const Motion* motion = nullptr;
  const PlaceObservation* place = nullptr;
  const Decision* decision = nullptr;
  const MapUpdate* map = nullptr;
  /// The named arrays of the plugin in the role cells, such as its neural activity (ArraySource);
  /// empty if it has none.
  const std::vector<NamedArray>* cells = nullptr;
  const MapGraph* graph = nullptr;  ///< null if unchanged, or if it is large and given later
  StageTimes stage_times_ns{};      ///< wall time, ns; 0 for the observers
  const std::vector<RunEvent>* events = nullptr;  ///< since the last snapshot; may be null
};

/// Description of the run, given to observers before the first frame.
struct RunInfo {
  static constexpr const char* kRecord = "run_info";
  std::string name;
  std::string directory;  ///< absolute path of the run directory; empty when nothing is recorded
  SourceInfo source;
  std::vector<ArrayInfo> arrays;  ///< descriptions of the cells' arrays and the source's sensors

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(name, "", "name of the run");
    TOLMAN_FIELD(directory, "", "absolute path of the run directory; empty without a record");
    TOLMAN_FIELD(source, "", "the data");
    TOLMAN_FIELD(arrays, "", "descriptions of the arrays");
  }
};

/// Reads the records of a run. It cannot change them: the host uses only the returned Status.
///
/// In a resumed run the observer first gets the recorded frames of the session, after begin(), so
/// that its output is complete. They have no images, sensors and revisions; they have the arrays of
/// the cells as often as these were recorded. Only the last of them has a graph: the checkpoint's.
class Observer : public Plugin {
 public:
  virtual Status begin(const RunInfo& run) = 0;
  virtual Status observe(const Snapshot& snapshot) = 0;
  /// After the last frame; `graph` is the final map.
  virtual Status finish(const MapGraph& graph) = 0;
};

}  // namespace tolman
