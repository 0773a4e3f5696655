// SPDX-License-Identifier: BSD-3-Clause
// The host's own keys, declared as plugins declare theirs.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/parameters.hpp"

namespace tolman::config {

inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// What follows an error among the findings of a stage (Context::findings).
enum class FindingPolicy : std::uint8_t { Stop, Continue };
inline constexpr std::array<std::string_view, 2> kFindingPolicyNames = {"stop", "continue"};
constexpr std::span<const std::string_view> enumNames(FindingPolicy) { return kFindingPolicyNames; }

/// Keys at the top of a file.
struct GeneralSettings {
  std::string name;  ///< empty: the file's name
  std::int64_t seed = 1;
  int threads = 0;
  FindingPolicy on_findings = FindingPolicy::Stop;
  std::string continue_from;  ///< key `continue`, a reserved word in C++
  std::string localise;
  /// The run whose saved map is loaded; empty: none.
  const std::string& earlier() const { return localise.empty() ? continue_from : localise; }
  static constexpr auto declaration() {
    return parameters(parameter("name", &GeneralSettings::name)
                          .doc("Name of the run; default: name of the file."),
                      parameter("seed", &GeneralSettings::seed)
                          .range(0, kNoLimit)
                          .doc("Seed of all random streams."),
                      parameter("threads", &GeneralSettings::threads)
                          .range(0, 1024)
                          .doc("Worker threads; 0 for one per processor."),
                      parameter("on_findings", &GeneralSettings::on_findings)
                          .doc("Damaged or contradictory data: stop the run, or continue without "
                               "them and warn."),
                      parameter("continue", &GeneralSettings::continue_from)
                          .path()
                          .doc("Run directory whose map this run continues; empty for a new map."),
                      parameter("localise", &GeneralSettings::localise)
                          .path()
                          .doc("Run directory in whose map the robot is found, without changing "
                               "that map; empty: none."));
  }
};

enum class PipelineMode : std::uint8_t { Lossless, Realtime };
inline constexpr std::array<std::string_view, 2> kPipelineModeNames = {"lossless", "realtime"};
constexpr std::span<const std::string_view> enumNames(PipelineMode) { return kPipelineModeNames; }

/// How a full queue handles another frame.
enum class QueuePolicy : std::uint8_t { DropOldest, Block };
inline constexpr std::array<std::string_view, 2> kQueuePolicyNames = {"drop_oldest", "block"};
constexpr std::span<const std::string_view> enumNames(QueuePolicy) { return kQueuePolicyNames; }

/// Keys below `pipeline`.
struct PipelineSettings {
  PipelineMode mode = PipelineMode::Lossless;
  int queue = 8;  ///< frames
  QueuePolicy input_policy = QueuePolicy::DropOldest;
  double speed = 1;  ///< times data time
  static constexpr auto declaration() {
    using S = PipelineSettings;
    return parameters(
        parameter("mode", &S::mode)
            .doc("lossless: every frame. realtime: paced by stamps; dropped frames are counted."),
        parameter("queue", &S::queue).range(1, 1024).unit("frames").doc("Length of each queue."),
        parameter("input_policy", &S::input_policy)
            .doc("realtime: what the full input queue does."),
        parameter("speed", &S::speed)
            .range(0.01, 1000)
            .doc("realtime: seconds of data per second."));
  }
};

enum class AlignmentChoice : std::uint8_t { Auto, Se3, Se2, Sim3, None };
inline constexpr std::array<std::string_view, 5> kAlignmentNames = {"auto", "se3", "se2", "sim3",
                                                                    "none"};
constexpr std::span<const std::string_view> enumNames(AlignmentChoice) { return kAlignmentNames; }

/// Which frames are evaluated.
enum class SessionScope : std::uint8_t { Own, Joint };
inline constexpr std::array<std::string_view, 2> kSessionScopeNames = {"own", "joint"};
constexpr std::span<const std::string_view> enumNames(SessionScope) { return kSessionScopeNames; }

enum class Segments : std::uint8_t { Auto, Kitti, Short };
inline constexpr std::array<std::string_view, 3> kSegmentsNames = {"auto", "kitti", "short"};
constexpr std::span<const std::string_view> enumNames(Segments) { return kSegmentsNames; }

enum class TruthMatch : std::uint8_t { Interpolate, Nearest };
inline constexpr std::array<std::string_view, 2> kTruthMatchNames = {"interpolate", "nearest"};
constexpr std::span<const std::string_view> enumNames(TruthMatch) { return kTruthMatchNames; }

/// Keys below `evaluation`. A list under `segments` is taken as `segment_lengths`.
struct EvaluationSettings {
  AlignmentChoice alignment = AlignmentChoice::Auto;
  Segments segments = Segments::Auto;
  std::vector<double> segment_lengths;  ///< m; empty: those of `segments`
  SessionScope sessions = SessionScope::Own;
  double loop_height = 0;  ///< m; places further apart in height differ; 0: off
  std::string truth;       ///< file; empty: the truth of the source
  TruthMatch truth_match = TruthMatch::Interpolate;
  double truth_offset = 0;  ///< s, added to the stamps of the images
  std::string body;         ///< empty: the truth is of the camera
  static constexpr auto declaration() {
    using S = EvaluationSettings;
    return parameters(parameter("truth", &S::truth)
                          .path()
                          .doc("File with true poses for any source: TUM, KITTI, EuRoC or CSV "
                               "with named columns; positions alone give position errors. "
                               "Empty: the truth of the source."),
                      parameter("truth_match", &S::truth_match)
                          .doc("Truth at the time of an image: interpolated between two poses "
                               "(never across a gap), or the nearest of both."),
                      parameter("truth_offset", &S::truth_offset)
                          .range(-1e6, 1e6)
                          .unit("s")
                          .doc("Added to the stamps of the images to find their true poses."),
                      parameter("body", &S::body)
                          .doc("Where the truth is measured, in the left camera: x,y,z (m) or "
                               "x,y,z,qx,qy,qz,qw; estimate: found from the motions of both, "
                               "with standard deviations. Empty: the camera."),
                      parameter("alignment", &S::alignment)
                          .doc("Transformation that aligns the estimate with the ground truth."),
                      parameter("segments", &S::segments)
                          .doc("Path lengths for drift: kitti, 100 to 800 m; short, 5 to 50 m; "
                               "auto, by the length of "
                               "the ground truth."),
                      parameter("segment_lengths", &S::segment_lengths)
                          .range(0.1, 1e6)
                          .unit("m")
                          .doc("Path lengths that replace those of `segments`."),
                      parameter("sessions", &S::sessions)
                          .doc("own: evaluate the frames of this session. joint: those of all "
                               "sessions; their ground "
                               "truth must be in one world frame."),
                      parameter("loop_height", &S::loop_height)
                          .range(0, 1e6)
                          .unit("m")
                          .doc("Loop links and recognised views between true places that are "
                               "further apart in height count as false, for buildings with "
                               "storeys. 0: only the distance of 10 m counts."));
  }
};

/// Keys below `record`.
struct RecordSettings {
  int arrays_every = -1;    ///< frames; -1: record::kAutomatic
  double state_every = 30;  ///< s
  bool replay = false;
  bool report = true;
  static constexpr auto declaration() {
    using S = RecordSettings;
    return parameters(
        parameter("arrays_every", &S::arrays_every)
            .range(-1, 1e6)
            .unit("frames")
            .doc("Named arrays of the cells are recorded every N frames; 0: never. "
                 "-1: at all of up to 5,000 frames, at every 2nd of up to 10,000, "
                 "at every 4th of up to 20,000, and so on: a run that goes on "
                 "removes the others again."),
        parameter("state_every", &S::state_every)
            .range(0, 1e6)
            .unit("s")
            .doc("Time between checkpoints, from which a killed run can be resumed "
                 "or continued; 0: none."),
        parameter("replay", &S::replay)
            .doc("Whether poses are recorded bit for bit, so that cells and map can be "
                 "run on the recorded answers of source, odometry and place."),
        parameter("report", &S::report)
            .doc("Whether the run ends with report.html and its figures; `tolman "
                 "report` writes them later."));
  }
};

/// Keys below `isolation`: limits of every stage that runs in its own process.
struct IsolationSettings {
  double deadline = 60;              ///< s
  std::int64_t memory_limit = 4096;  ///< MiB
  static constexpr auto declaration() {
    using S = IsolationSettings;
    return parameters(
        parameter("deadline", &S::deadline)
            .range(0, 1e6)
            .unit("s")
            .doc("Longest time of one call; then the process is killed. 0 for no limit."),
        parameter("memory_limit", &S::memory_limit)
            .range(0, 1e9)
            .unit("MiB")
            .doc("Memory limit for the data of one process. 0 for no limit."));
  }
};

/// Keys below `checks`: what the host checks between the stages.
struct CheckSettings {
  bool images = true;
  double max_speed = 100;        ///< m/s
  double max_acceleration = 50;  ///< m/s^2
  double max_turn_rate = 10;     ///< rad/s
  static constexpr auto declaration() {
    using S = CheckSettings;
    return parameters(
        parameter("images", &S::images)
            .doc("Whether repeated images, exchanged sides and pairs that do not belong together "
                 "are kept from the stages."),
        parameter("max_speed", &S::max_speed)
            .range(0, kNoLimit)
            .unit("m/s")
            .doc("A faster motion of odometry is replaced by a prediction, in state lost."),
        parameter("max_acceleration", &S::max_acceleration)
            .range(0, kNoLimit)
            .unit("m/s^2")
            .doc("Likewise a motion that changes the speed faster. Changes below 0.1 m per frame "
                 "period (1 m/s at 10 Hz) may be position errors, and are never impossible."),
        parameter("max_turn_rate", &S::max_turn_rate)
            .range(0, kNoLimit)
            .unit("rad/s")
            .doc("Likewise a motion that turns faster."));
  }
};

enum class RectificationMode : std::uint8_t { Auto, Off };
inline constexpr std::array<std::string_view, 2> kRectificationModeNames = {"auto", "off"};
constexpr std::span<const std::string_view> enumNames(RectificationMode) {
  return kRectificationModeNames;
}

/// Keys below `rectification`: for sources whose images are not rectified.
struct RectificationSettings {
  RectificationMode mode = RectificationMode::Auto;
  double scale = 1;
  double field_of_view = 90;  ///< deg
  static constexpr auto declaration() {
    using S = RectificationSettings;
    return parameters(
        parameter("mode", &S::mode)
            .doc("auto: raw images are rectified. off: the stages get the left image as it is, "
                 "uncalibrated."),
        parameter("scale", &S::scale)
            .range(0.05, 4)
            .doc("Pixels of a rectified image per raw pixel, at the centre."),
        parameter("field_of_view", &S::field_of_view)
            .range(10, 150)
            .unit("deg")
            .doc("The most that a rectified image shows, across and down; for wide fisheye "
                 "cameras."));
  }
};

/// Keys below `images`: for the images of every source, the mask before rectification, the others
/// after it.
struct ImageSettings {
  std::vector<double> crop;  ///< px: left, top, width, height; empty: all
  double scale = 1;
  std::vector<double> mask{};  ///< px: left, top, width, height of each rectangle
  static constexpr auto declaration() {
    using S = ImageSettings;
    return parameters(
        parameter("mask", &S::mask)
            .range(0, 65000)
            .unit("px")
            .doc("Rectangles of the recorded images without the scene (own bonnet, printed time): "
                 "left, top, width, height of each. They get what is around them, smoothed."),
        parameter("crop", &S::crop)
            .range(0, 65000)
            .unit("px")
            .doc("Part of the images that the stages get: left, top, width, height; empty: all."),
        parameter("scale", &S::scale)
            .range(0.02, 1)
            .doc("Pixels per pixel of that part; each is the mean of the area that it covers. The "
                 "calibration follows."));
  }
};

enum class FailurePolicy : std::uint8_t { Stop, Skip, Restart };
inline constexpr std::array<std::string_view, 3> kFailurePolicyNames = {"stop", "skip", "restart"};
constexpr std::span<const std::string_view> enumNames(FailurePolicy) { return kFailurePolicyNames; }

/// Where a stage runs: in the host, or in its own process.
enum class Isolation : std::uint8_t { None, Process };
inline constexpr std::array<std::string_view, 2> kIsolationNames = {"none", "process"};
constexpr std::span<const std::string_view> enumNames(Isolation) { return kIsolationNames; }

/// Keys of a stage that the host reads; all others are parameters of the plugin.
struct StageSettings {
  std::string plugin;
  std::string name;  ///< empty: the role, or for an observer the plugin
  FailurePolicy on_failure = FailurePolicy::Stop;
  Isolation isolation = Isolation::None;
  static constexpr auto declaration() {
    using S = StageSettings;
    return parameters(parameter("plugin", &S::plugin).required().doc("Id of the plugin."),
                      parameter("name", &S::name).doc("Name of this stage in records and logs."),
                      parameter("on_failure", &S::on_failure)
                          .doc("stop the run, skip the frame, or skip it and restart the process."),
                      parameter("isolation", &S::isolation)
                          .doc("Whether the stage runs in the host (none) or in its own process."));
  }
};

/// The key of a stage whose plugin runs a program.
struct ProgramSettings {
  std::string file;
  static constexpr auto declaration() {
    return parameters(parameter("file", &ProgramSettings::file)
                          .required()
                          .path()
                          .doc("The program that is the plugin."));
  }
};
inline Schema programSchema() { return schemaOf<ProgramSettings>(); }

}  // namespace tolman::config
