// SPDX-License-Identifier: BSD-3-Clause
#include "engine/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/saved_state.hpp"

namespace tolman::engine {
namespace {

namespace fs = std::filesystem;

/// The record of frame `frame`, the last one of a checkpoint. Throws Failed if there is none.
template <Record R>
R recordOf(const std::vector<R>& records, std::int64_t frame, const fs::path& directory) {
  const auto found = std::ranges::find(records, frame, &R::frame);
  if (found != records.end()) return *found;
  refuseToContinue(fmt::format(
      "{}: its checkpoint is of frame {}, which run.sqlite does not have (was the power lost?); "
      "run it again",
      directory.string(), frame));
}

/// How many templates place recognition can have at most after frame `last`: a call that failed,
/// and is recorded as None, may have made one.
std::int64_t mostTemplates(const std::vector<PlaceObservation>& recorded, std::int64_t last) {
  std::int64_t given = 0;
  std::int64_t none = 0;
  for (const PlaceObservation& observation : recorded) {
    if (observation.frame > last) continue;
    given = std::max(given, observation.template_id + 1);
    none += observation.recognition == Recognition::None ? 1 : 0;
  }
  return given + none;
}

/// The record holds a rotation as a quaternion, so the last bits may differ.
bool isSameMotion(const Motion& a, const Motion& b) {
  constexpr double kRounding = 1e-9;  // m and rad
  return a.T_previous_current.isApprox(b.T_previous_current, kRounding);
}

/// Compares stamp, source index and truth; the record holds a rotation as a quaternion.
bool isSameFrame(const Frame& a, const Frame& b) {
  constexpr double kRounding = 1e-9;
  return a.stamp_ns == b.stamp_ns && a.source_index == b.source_index &&
         a.has_truth == b.has_truth &&
         (!a.has_truth || a.T_world_camera_truth.isApprox(b.T_world_camera_truth, kRounding));
}

/// Tracks the recorded frames again; frames that a realtime run dropped are skipped again.
class RepeatedOdometry {
 public:
  RepeatedOdometry(Assembly& assembly, const std::vector<Motion>& recorded,
                   const std::vector<Frame>& frames)
      : assembly_(assembly), recorded_(recorded), frames_(frames) {}

  /// Returns the motion of the last frame.
  Motion repeat(std::int64_t last_frame, const Cancellation& cancellation) {
    for (std::int64_t done = -1; done < last_frame && !cancellation.requested();) {
      Frame frame;
      const Status read = assembly_.source().next(frame);
      if (read.code() == StatusCode::EndOfStream) {
        refuseToContinue(fmt::format("{}: has fewer frames than were recorded ({}); {}",
                                     assembly_.stageName(Role::Source), last_frame + 1, kRemedy));
      }
      require(read, FailureKind::Dataset, assembly_.stageName(Role::Source));
      done = frame.frame;
      while (next_ + 1 < recorded_.size() && recorded_[next_].frame < frame.frame) ++next_;
      if (recorded_[next_].frame != frame.frame) continue;
      compare(frame);
      (void)assembly_.checkedOdometry().admit(frame);  // its note is in the record
      track(frame, recorded_[next_]);
    }
    return last_;
  }

 private:
  static constexpr const char* kRemedy =
      "resume with the data of the recorded run, or run it again";

  void compare(const Frame& frame) {
    const auto recorded = std::ranges::lower_bound(frames_, frame.frame, {}, &Frame::frame);
    if (recorded != frames_.end() && recorded->frame == frame.frame &&
        isSameFrame(frame, *recorded)) {
      return;
    }
    refuseToContinue(
        fmt::format("{}: stamp or true pose of frame {} is another than was recorded; {}",
                    assembly_.stageName(Role::Source), frame.frame, kRemedy));
  }

  void track(const Frame& frame, const Motion& before) {
    Motion motion;
    Impossible impossible;
    const bool failed = !assembly_.checkedOdometry().track(frame, motion, impossible).isOk();
    last_ = failed ? before : motion;  // after a failure the record has the predicted motion
    if (isSameMotion(last_, before)) return;
    refuseToContinue(fmt::format(
        "{}: gives another motion at frame {} than was recorded; data, plugin or parameters have "
        "changed. Resume with those of the recorded run, or run it again",
        assembly_.stageName(Role::Odometry), frame.frame));
  }

  Assembly& assembly_;
  const std::vector<Motion>& recorded_;
  const std::vector<Frame>& frames_;
  std::size_t next_ = 0;
  Motion last_;
};

}  // namespace

ResumePoint resumeAt(Assembly& assembly, const fs::path& directory,
                     const Cancellation& cancellation) {
  constexpr FailureKind kKind = FailureKind::Continuation;
  const auto reader = require(record::RunReader::open(directory), kKind);
  const auto sessions = require(reader->sessions(), kKind);
  if (sessions.empty())
    refuseToContinue(directory.string() + ": was ended before its first frame; run it again");
  const std::int64_t first_frame = sessions.back().first_frame;
  assembly.source().startAt(first_frame);
  assembly.odometry().startAt(first_frame);

  ResumePoint point;
  point.checkpoint = loadCheckpoint(assembly, directory);
  const std::int64_t last = point.checkpoint.frame;
  const auto motions = require(reader->records<Motion>(), kKind);
  (void)recordOf(motions, last, directory);  // throws if frames to be repeated are missing
  point.decision = recordOf(require(reader->records<Decision>(), kKind), last, directory);
  point.map = recordOf(require(reader->records<MapUpdate>(), kKind), last, directory);
  MapGraph graph;
  require(assembly.map().graph(graph), kKind);
  const std::int64_t templates =
      mostTemplates(require(reader->records<PlaceObservation>(), kKind), last);
  assembly.place().resetChecks(-1, templates);
  assembly.cells().resetChecks(static_cast<std::int64_t>(graph.experiences.size()), templates);
  const auto frames = require(reader->records<Frame>(), kKind);
  if (const auto scale = require(reader->lastScale(last + 1), kKind)) {
    const bool is_earlier = scale->frame < first_frame;
    point.scale = {scale->is_known,
                   is_earlier ? assembly.system().config.general.continue_from : std::string()};
  }
  point.motion = RepeatedOdometry(assembly, motions, frames).repeat(last, cancellation);
  return point;
}

}  // namespace tolman::engine
