// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/stages.hpp"

#include <numbers>
#include <string>

namespace tolman::plugins {
namespace {

template <Record R>
Status checkValues(const R& record) {
  const std::string bad = firstInvalidField(record);
  if (bad.empty()) return Status::ok();
  return Status::failed("the answer has NaN, infinity or an impossible value in '" + bad + "'");
}

/// An answer belongs to the frame that was asked about, and holds numbers.
template <Record Question, Record Answer>
Status checkAnswer(const Question& question, const Answer& answer) {
  if (answer.frame != question.frame) {
    return Status::failed("answered for frame " + std::to_string(answer.frame) +
                          "; copy `frame` from the input");
  }
  if (answer.stamp_ns != question.stamp_ns) {
    return Status::failed("answered with time " + std::to_string(answer.stamp_ns) + " ns, asked " +
                          std::to_string(question.stamp_ns) +
                          " ns; copy `stamp_ns` from the input");
  }
  return checkValues(answer);
}

Status checkRevisions(const std::vector<MotionRevision>& revisions, std::int64_t oldest,
                      std::int64_t newest) {
  for (const MotionRevision& revision : revisions) {
    if (revision.frame < oldest || revision.frame > newest) {
      return Status::failed("revised frame " + std::to_string(revision.frame) +
                            ", which is not one of the past");
    }
    if (Status status = checkValues(revision); !status.isOk()) return status;
  }
  return Status::ok();
}

void shift(std::vector<MotionRevision>& revisions, std::int64_t frames) {
  for (MotionRevision& revision : revisions) revision.frame += frames;
}

Status checkGraph(const MapGraph& graph) {
  const auto count = static_cast<std::int64_t>(graph.experiences.size());
  for (std::int64_t i = 0; i < count; ++i) {
    const Experience& experience = graph.experiences[static_cast<std::size_t>(i)];
    if (experience.id != i) return Status::failed("experience ids are not dense from 0");
    if (Status status = checkValues(experience); !status.isOk()) return status;
  }
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    const Link& link = graph.links[i];
    if (link.id != static_cast<std::int64_t>(i)) return Status::failed("link ids are not dense");
    if (link.from < 0 || link.from >= count || link.to < 0 || link.to >= count) {
      return Status::failed("link " + std::to_string(i) + " ends at no experience");
    }
    if (Status status = checkValues(link); !status.isOk()) return status;
  }
  return Status::ok();
}

}  // namespace

Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates) {
  const std::string id = "template " + std::to_string(observation.template_id);
  switch (observation.recognition) {
    case Recognition::None:
      if (observation.template_id == -1) break;
      return Status::failed("answered None with " + id + "; None has template_id -1");
    case Recognition::Novel:
      if (observation.template_id == templates || templates < 0) break;
      return Status::failed("made " + id + "; ids are dense, the next one is " +
                            std::to_string(templates));
    case Recognition::Familiar:
      if (observation.template_id >= 0 && (observation.template_id < templates || templates < 0)) {
        break;
      }
      return Status::failed("recognised " + id + ", which was never made");
  }
  return Status::ok();
}

Status SourceStage::info(SourceInfo& info) {
  const Status status = instance_->call<Source>("info", -1, [&](Source& source) {
    const Status answered = source.info(info);
    return answered.isOk() ? checkValues(info.rig) : answered;
  });
  if (status.isOk()) info_ = info;
  return status;
}

Status SourceStage::check(const Frame& frame) const {
  if (frame.frame != next_frame_) {
    return Status::failed("gave frame " + std::to_string(frame.frame) + " instead of " +
                          std::to_string(next_frame_));
  }
  if (frame.frame > 0 && frame.stamp_ns <= last_stamp_ns_) {
    return Status::invalidInput("time does not increase: " + std::to_string(frame.stamp_ns) +
                                " ns after " + std::to_string(last_stamp_ns_) + " ns");
  }
  for (const Image* image : {&frame.left, &frame.right}) {
    const bool fits = image->width() == info_.rig.width && image->height() == info_.rig.height;
    if (!image->empty() && !fits) {
      return Status::invalidInput("an image of " + std::to_string(image->width()) + "x" +
                                  std::to_string(image->height()) + " px; the rig has " +
                                  std::to_string(info_.rig.width) + "x" +
                                  std::to_string(info_.rig.height));
    }
  }
  return checkValues(frame);
}

Status SourceStage::next(Frame& frame) {
  const Status status =
      instance_->call<Source>("next", first_frame_ + next_frame_, [&](Source& source) {
        const Status answered = source.next(frame);
        return answered.isOk() ? check(frame) : answered;
      });
  if (!status.isOk()) return status;
  ++next_frame_;
  last_stamp_ns_ = frame.stamp_ns;
  frame.frame += first_frame_;
  return status;
}

void SourceStage::expect(std::int64_t next_frame, std::int64_t last_stamp_ns) {
  next_frame_ = next_frame;
  last_stamp_ns_ = last_stamp_ns;
}

Status SourceStage::inspect(std::vector<Finding>& findings) {
  return instance_->call<Source>("inspect", -1,
                                 [&](Source& source) { return source.inspect(findings); });
}

Status OdometryStage::track(const Frame& frame, Motion& motion) {
  return instance_->call<Odometry>("track", frame.frame, [&](Odometry& odometry) {
    Status status = track(odometry, frame, motion);
    if (status.isOk()) status = checkAnswer(frame, motion);
    if (status.isOk()) status = checkRevisions(motion.revisions, first_frame_, frame.frame);
    return status;
  });
}

/// In the plugin's numbers and back.
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
  return instance_->call<Odometry>("finish", -1, [&](Odometry& odometry) {
    const Status status = odometry.finish(revisions);
    shift(revisions, first_frame_);
    return status.isOk() ? checkRevisions(revisions, first_frame_, INT64_MAX) : status;
  });
}

PlaceInput PlaceStage::input() {
  PlaceInput input = PlaceInput::Frame;
  (void)instance_->call<Place>("input", -1, [&](Place& place) {
    input = place.input();
    return Status::ok();
  });
  return input;
}

Status PlaceStage::observe(const Frame& frame, const Motion* motion,
                           PlaceObservation& observation) {
  const Status answered = instance_->call<Place>("observe", frame.frame, [&](Place& place) {
    Status status = place.observe(frame, motion, observation);
    if (status.isOk()) status = checkAnswer(frame, observation);
    if (status.isOk()) status = checkTemplateId(observation, templates_);
    return status;
  });
  if (!answered.isOk()) {
    templates_ = -1;  // it may have made one nevertheless
  } else if (observation.recognition == Recognition::Novel) {
    templates_ = observation.template_id + 1;
  }
  return answered;
}

Status PlaceStage::finish() {
  return instance_->call<Place>("finish", -1, [](Place& place) { return place.finish(); });
}

Status CellsStage::step(const Motion& motion, const PlaceObservation& observation,
                        Decision& decision) {
  return instance_->call<Cells>("step", motion.frame, [&](Cells& cells) {
    Status status = cells.step(motion, observation, decision);
    if (status.isOk()) status = checkAnswer(motion, decision);
    if (status.isOk()) status = check(decision);
    if (status.isOk() && decision.action == Action::CreateExperience) ++experiences_;
    return status;
  });
}

Status CellsStage::check(const Decision& decision) const {
  const std::string id = std::to_string(decision.experience);
  if (decision.action == Action::CreateExperience) {
    if (decision.experience != experiences_) {
      return Status::failed("created experience " + id + "; ids are dense, the next one is " +
                            std::to_string(experiences_));
    }
  } else if (decision.experience < (decision.action == Action::Stay ? -1 : 0) ||
             decision.experience >= experiences_) {
    return Status::failed("decided for experience " + id + ", which does not exist");
  }
  if (decision.heading < 0 || decision.heading >= 2 * std::numbers::pi) {
    return Status::failed("heading " + std::to_string(decision.heading) + " is not in [0, 2 pi)");
  }
  if (decision.confidence < 0 || decision.confidence > 1) {
    return Status::failed("confidence " + std::to_string(decision.confidence) +
                          " is not in [0, 1]");
  }
  return Status::ok();
}

Status CellsStage::finish() {
  return instance_->call<Cells>("finish", -1, [](Cells& cells) { return cells.finish(); });
}

Status MapStage::update(const Motion& motion, const Decision& decision, MapUpdate& update) {
  return instance_->call<Map>("update", motion.frame, [&](Map& map) {
    const Status status = map.update(motion, decision, update);
    return status.isOk() ? checkAnswer(motion, update) : status;
  });
}

Status MapStage::poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) {
  return instance_->call<Map>("poseOf", frame, [&](Map& map) {
    const Status status = map.poseOf(frame, T_world_camera);
    if (!status.isOk() || T_world_camera.matrix().allFinite()) return status;
    return Status::failed("the pose is not finite");
  });
}

Status MapStage::graph(MapGraph& graph) {
  return instance_->call<Map>("graph", -1, [&](Map& map) {
    const Status status = map.graph(graph);
    return status.isOk() ? checkGraph(graph) : status;
  });
}

Status MapStage::finish(const std::vector<MotionRevision>& revisions) {
  return instance_->call<Map>("finish", -1, [&](Map& map) { return map.finish(revisions); });
}

Status ObserverStage::begin(const RunInfo& run) {
  return instance_->call<Observer>("begin", -1,
                                   [&](Observer& observer) { return observer.begin(run); });
}

Status ObserverStage::observe(const Snapshot& snapshot) {
  return instance_->call<Observer>("observe", snapshot.frame->frame,
                                   [&](Observer& observer) { return observer.observe(snapshot); });
}

Status ObserverStage::finish(const MapGraph& graph) {
  return instance_->call<Observer>("finish", -1,
                                   [&](Observer& observer) { return observer.finish(graph); });
}

}  // namespace tolman::plugins
