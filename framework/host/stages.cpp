// SPDX-License-Identifier: BSD-3-Clause
#include "host/stages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/values.hpp"
#include "tolman/geometry.hpp"

namespace tolman::host {

Status MotionTimes::check(const Frame& frame, const Motion& motion) const {
  constexpr double kFactor = 10;
  if (motion.dt < 0) return Status::failed(fmt::format("'dt' is {:g} s", motion.dt));
  if (last_frame_ == INT64_MAX) return Status::ok();
  const double shortest = 1e-9 * static_cast<double>(frame.stamp_ns - given_ns_);
  const double longest = 1e-9 * static_cast<double>(frame.stamp_ns - answered_ns_);
  const bool unknown = motion.state == TrackingState::Initialising;  // a new process has dt = 0
  if (motion.dt <= kFactor * longest && (unknown || kFactor * motion.dt >= shortest)) {
    return Status::ok();
  }
  return Status::failed(fmt::format(
      "'dt' is {:g} s, the stamps say {:g} s; see setPlanarVelocity()", motion.dt, shortest));
}

void MotionTimes::add(const Frame& frame, bool answered) {
  if (answered || last_frame_ == INT64_MAX) answered_ns_ = frame.stamp_ns;
  given_ns_ = frame.stamp_ns;
  last_frame_ = frame.frame;
}

namespace {

/// An answer must have the frame number and the time stamp of its input, and finite values.
template <Record Question, Record Answer>
Status checkAnswer(const Question& question, const Answer& answer) {
  if (answer.frame != question.frame) {
    return Status::failed(
        fmt::format("answered for frame {}; copy `frame` from the input", answer.frame));
  }
  if (answer.stamp_ns != question.stamp_ns) {
    return Status::failed(
        fmt::format("answered with time {} ns instead of {} ns; copy `stamp_ns` from the input",
                    answer.stamp_ns, question.stamp_ns));
  }
  return checkValues(answer);
}

/// Whether the pose of a frame agrees with the pose of the experience that was created at it. The
/// tolerance allows for a later loop that moves the frame relative to the experience, within the
/// uncertainty of its links.
bool isAtExperience(const Eigen::Isometry3d& T_world_camera,
                    const Eigen::Isometry3d& T_world_experience) {
  constexpr double kApart = 0.1;        // m
  constexpr double kApartShare = 0.01;  // of the distance from the origin
  constexpr double kTurned = 0.1;       // rad
  const double most = kApart + kApartShare * T_world_camera.translation().norm();
  const Eigen::Isometry3d between = T_world_camera.inverse() * T_world_experience;
  return between.translation().norm() <= most && logSo3(between.linear()).norm() <= kTurned;
}

void shift(std::vector<MotionRevision>& revisions, std::int64_t frames) {
  for (MotionRevision& revision : revisions) revision.frame += frames;
}

}  // namespace

Status SourceStage::info(SourceInfo& info) {
  const Status status = call("info", -1, [&](Source& source) {
    const Status answered = source.info(info);
    if (answered.isOk() && info.frames < -1) {
      return Status::failed(
          fmt::format("gave {} frames; use -1 for an unknown number", info.frames));
    }
    if (!answered.isOk()) return answered;
    const Status values = checkValues(info.rig);
    return values.isOk() ? checkRig(info.rig) : values;
  });
  if (status.isOk()) info_ = info;
  return status;
}

Status SourceStage::check(const Frame& frame) {
  if (frame.frame != next_frame_) {
    return Status::failed(fmt::format("gave frame {} instead of {}", frame.frame, next_frame_));
  }
  if (frame.frame > 0 && frame.stamp_ns <= last_stamp_ns_) {
    return Status::invalidInput(
        fmt::format("time does not increase: {} ns after {} ns", frame.stamp_ns, last_stamp_ns_));
  }
  if (frame.stamp_ns < 0) {
    return Status::invalidInput(fmt::format("time is negative: {} ns", frame.stamp_ns));
  }
  if (frame.has_truth && !info_.has_truth) {
    return Status::failed(
        "gave a true pose, but info() says that there are none; set has_truth in both, or in none");
  }
  Status status = checkImages(frame, info_.rig);
  if (status.isOk()) status = checkValues(frame);
  return status.isOk() ? sensors_.checkShapes(frame.sensors) : status;
}

Status SourceStage::next(Frame& frame) {
  frame = Frame{};  // a source may set only some fields, and callers use one object for many frames
  const Status status = call("next", first_frame_ + next_frame_, [&](Source& source) {
    const Status answered = source.next(frame);
    return answered.isOk() ? check(frame) : answered;
  });
  if (!status.isOk()) return status;
  const bool without_image = info_.rig.width > 0 && frame.left.empty();
  if (without_image && frame.defect.empty())
    frame.defect = "the source gave no image and no reason";
  ++next_frame_;
  last_stamp_ns_ = frame.stamp_ns;
  frame.frame += first_frame_;
  return status;
}

void SourceStage::resetChecks(std::int64_t next_frame, std::int64_t last_stamp_ns) {
  next_frame_ = next_frame;
  last_stamp_ns_ = last_stamp_ns;
  sensors_ = {};
}

Status OdometryStage::track(const Frame& frame, Motion& motion) {
  const Status answered = call("track", frame.frame, [&](Odometry& odometry) {
    Status status = track(odometry, frame, motion);
    if (status.isOk()) status = checkAnswer(frame, motion);
    if (status.isOk()) status = checkMotion(motion, frame.frame == first_frame_);
    if (status.isOk()) status = times_.check(frame, motion);
    if (status.isOk()) status = checkRevisions(motion.revisions, first_frame_, frame.frame - 1);
    return status;
  });
  times_.add(frame, answered.isOk());
  return answered;
}

/// Calls the plugin, whose frame numbers begin with 0 in each session, and converts the numbers.
Status OdometryStage::track(Odometry& odometry, const Frame& frame, Motion& motion) const {
  if (first_frame_ == 0) return odometry.track(frame, motion);
  Frame own = frame;
  own.frame -= first_frame_;
  const Status status = odometry.track(own, motion);
  motion.frame += first_frame_;
  if (motion.points_frame >= 0) motion.points_frame += first_frame_;
  shift(motion.revisions, first_frame_);
  return status;
}

Status OdometryStage::finish(std::vector<MotionRevision>& revisions) {
  return call("finish", -1, [&](Odometry& odometry) {
    const Status status = odometry.finish(revisions);
    shift(revisions, first_frame_);
    if (!status.isOk()) return status;
    return checkRevisions(revisions, first_frame_, times_.lastFrame());
  });
}

PlaceInput PlaceStage::input() {
  PlaceInput input = PlaceInput::Frame;
  (void)call("input", -1, [&](Place& place) {
    input = place.input();
    return Status::ok();
  });
  return input;
}

Status PlaceStage::observe(const Frame& frame, const Motion* motion,
                           PlaceObservation& observation) {
  const Status answered = call("observe", frame.frame, [&](Place& place) {
    Status status = place.observe(frame, motion, observation);
    if (status.isOk()) status = checkAnswer(frame, observation);
    if (status.isOk()) status = checkTemplateId(observation, templates_);
    if (status.isOk()) status = checkPlace(observation);
    if (status.isOk() && localises_ && observation.recognition == Recognition::Novel) {
      return Status::failed("made a template, although the map must stay as it is");
    }
    return status;
  });
  if (!answered.isOk()) {
    templates_ = -1;  // it may have created a template
  } else if (observation.recognition == Recognition::Novel) {
    templates_ = observation.template_id + 1;
  }
  return answered;
}

Status CellsStage::step(const Motion& motion, const PlaceObservation& observation,
                        Decision& decision) {
  const Status answered = call("step", motion.frame, [&](Cells& cells) {
    templates_ = std::max(templates_, observation.template_id + 1);
    Status status = cells.step(motion, observation, decision);
    if (status.isOk()) status = checkAnswer(motion, decision);
    if (!status.isOk()) return status;
    return localises_ ? checkLocalised(decision, experiences_)
                      : checkDecision(decision, experiences_, last_, templates_);
  });
  last_ = answered.isOk() ? decision.experience : kUnknown;
  if (answered.isOk() && decision.action == Action::CreateExperience) ++experiences_;
  return answered;
}

Status MapStage::update(const Motion& motion, const Decision& decision, MapUpdate& update) {
  if (motion.frame == 0) known_.templates = 0;  // a map with an earlier session may know others
  known_.templates = std::max(known_.templates, decision.template_id + 1);
  const std::int64_t templates = known_.templates;
  const Status answered = call("update", motion.frame, [&](Map& map) {
    Status status = map.update(motion, decision, update);
    if (status.isOk()) status = checkAnswer(motion, update);
    return status.isOk() ? checkUpdate(update, known_.version) : status;
  });
  if (answered.isOk()) {
    known_ = {motion.frame, update.version, update.experiences,
              update.links, update.loops,   templates};
    last_ = update;
  } else {  // the map may have changed, and this frame may have no record
    known_ = {.newest_frame = known_.newest_frame, .templates = templates};
    last_.reset();
  }
  return answered;
}

Status MapStage::poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) {
  return call("poseOf", frame, [&](Map& map) {
    const Status status = map.poseOf(frame, T_world_camera);
    if (!status.isOk()) return status;
    const char* what = wrongIn(T_world_camera);
    return what == nullptr ? status
                           : Status::failed(fmt::format(fmt::runtime(what), "T_world_camera"));
  });
}

Status MapStage::checkLastPose() {
  if (!last_) return Status::ok();
  const MapUpdate last = *last_;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  const Status status = poseOf(last.frame, T_world_camera);
  if (!status.isOk()) return status;
  return call("poseOf", last.frame, [&](Map&) {
    return checkSamePose(T_world_camera, last.T_world_camera, "the update");
  });
}

Status MapStage::graph(MapGraph& graph) {
  return call("graph", -1, [&](Map& map) {
    Status status = map.graph(graph);
    if (status.isOk()) status = checkGraph(graph, known_);
    return status.isOk() && last_ ? checkPlaced(*last_, graph) : status;
  });
}

Status MapStage::finish(const std::vector<MotionRevision>& revisions) {
  last_.reset();  // finish() may move all poses and add links
  known_.links = known_.loops = -1;
  return call("finish", -1, &Map::finish, revisions);
}

Status MapStage::checkExperiences(const MapGraph& graph, const KnownPoses& pose_of) {
  for (const Experience& experience : graph.experiences) {
    const Eigen::Isometry3d* T_world_camera = pose_of(experience.frame);
    if (T_world_camera == nullptr) continue;
    if (isAtExperience(*T_world_camera, experience.T_world_experience)) continue;
    const Status status = call("poseOf", experience.frame, [&](Map&) {
      return checkSamePose(
          *T_world_camera, experience.T_world_experience,
          fmt::format("graph() of experience {}, which was made there", experience.id));
    });
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

}  // namespace tolman::host
