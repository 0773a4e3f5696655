// SPDX-License-Identifier: BSD-3-Clause
#include "host/stages.hpp"

#include <fmt/format.h>

#include <numbers>

namespace tolman::host {
namespace {

template <class... T>
Status failed(fmt::format_string<const T&...> text, const T&... values) {
  return Status::failed(fmt::format(text, values...));
}

template <Record R>
Status checkValues(const R& record) {
  const std::string bad = firstInvalidField(record);
  if (bad.empty()) return Status::ok();
  return failed("the answer has NaN, infinity or an illegal value in '{}'", bad);
}

/// An answer must have frame and stamp of its input, and finite values.
template <Record Question, Record Answer>
Status checkAnswer(const Question& question, const Answer& answer) {
  if (answer.frame != question.frame) {
    return failed("answered for frame {}; copy `frame` from the input", answer.frame);
  }
  if (answer.stamp_ns != question.stamp_ns) {
    return failed("answered with time {} ns instead of {} ns; copy `stamp_ns` from the input",
                  answer.stamp_ns, question.stamp_ns);
  }
  return checkValues(answer);
}

Status checkRevisions(const std::vector<MotionRevision>& revisions, std::int64_t oldest,
                      std::int64_t newest) {
  for (const MotionRevision& revision : revisions) {
    if (revision.frame < oldest || revision.frame > newest) {
      return failed("revised frame {}, which is not a past frame", revision.frame);
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
      return failed("link {} has an unknown experience", i);
    }
    if (Status status = checkValues(link); !status.isOk()) return status;
  }
  return Status::ok();
}

}  // namespace

Status checkTemplateId(const PlaceObservation& observation, std::int64_t templates) {
  const std::int64_t id = observation.template_id;
  switch (observation.recognition) {
    case Recognition::None:
      if (id == -1) break;
      return failed("answered None with template {}; None has template_id -1", id);
    case Recognition::Novel:
      if (id == templates || templates < 0) break;
      return failed("made template {}; ids are dense, the next one is {}", id, templates);
    case Recognition::Familiar:
      if (id >= 0 && (id < templates || templates < 0)) break;
      return failed("recognised template {}, which was never made", id);
  }
  return Status::ok();
}

Status SourceStage::info(SourceInfo& info) {
  const Status status = call("info", -1, [&](Source& source) {
    const Status answered = source.info(info);
    return answered.isOk() ? checkValues(info.rig) : answered;
  });
  if (status.isOk()) info_ = info;
  return status;
}

Status SourceStage::check(const Frame& frame) const {
  if (frame.frame != next_frame_) {
    return failed("gave frame {} instead of {}", frame.frame, next_frame_);
  }
  if (frame.frame > 0 && frame.stamp_ns <= last_stamp_ns_) {
    return Status::invalidInput(
        fmt::format("time does not increase: {} ns after {} ns", frame.stamp_ns, last_stamp_ns_));
  }
  for (const Image* image : {&frame.left, &frame.right}) {
    const bool fits = image->width() == info_.rig.width && image->height() == info_.rig.height;
    if (!image->empty() && !fits) {
      return Status::invalidInput(fmt::format("an image of {}x{} px; the rig has {}x{}",
                                              image->width(), image->height(), info_.rig.width,
                                              info_.rig.height));
    }
  }
  return checkValues(frame);
}

Status SourceStage::next(Frame& frame) {
  const Status status = call("next", first_frame_ + next_frame_, [&](Source& source) {
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

Status OdometryStage::track(const Frame& frame, Motion& motion) {
  return call("track", frame.frame, [&](Odometry& odometry) {
    Status status = track(odometry, frame, motion);
    if (status.isOk()) status = checkAnswer(frame, motion);
    if (status.isOk()) status = checkRevisions(motion.revisions, first_frame_, frame.frame);
    return status;
  });
}

/// Converts frame numbers to those of the plugin and back.
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
    return status.isOk() ? checkRevisions(revisions, first_frame_, INT64_MAX) : status;
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
  return call("step", motion.frame, [&](Cells& cells) {
    Status status = cells.step(motion, observation, decision);
    if (status.isOk()) status = checkAnswer(motion, decision);
    if (status.isOk()) status = check(decision);
    if (status.isOk() && decision.action == Action::CreateExperience) ++experiences_;
    return status;
  });
}

Status CellsStage::check(const Decision& decision) const {
  const std::int64_t id = decision.experience;
  if (decision.action == Action::CreateExperience) {
    if (id != experiences_) {
      return failed("created experience {}; ids are dense, the next one is {}", id, experiences_);
    }
  } else if (id < (decision.action == Action::Stay ? -1 : 0) || id >= experiences_) {
    return failed("decided for experience {}, which does not exist", id);
  }
  for (const EarlierLoop& loop : decision.earlier) {
    if (loop.frame < 0 || loop.frame >= decision.frame) {
      return failed("answered a loop of frame {}, which is not an earlier frame", loop.frame);
    }
    if (loop.experience < 0 || loop.experience >= experiences_) {
      return failed("answered a loop of frame {} to experience {}, which does not exist",
                    loop.frame, loop.experience);
    }
  }
  if (decision.heading < 0 || decision.heading >= 2 * std::numbers::pi) {
    return failed("heading {:f} is not in [0, 2 pi)", decision.heading);
  }
  if (decision.confidence < 0 || decision.confidence > 1) {
    return failed("confidence {:f} is not in [0, 1]", decision.confidence);
  }
  return Status::ok();
}

Status MapStage::update(const Motion& motion, const Decision& decision, MapUpdate& update) {
  return call("update", motion.frame, [&](Map& map) {
    const Status status = map.update(motion, decision, update);
    return status.isOk() ? checkAnswer(motion, update) : status;
  });
}

Status MapStage::poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) {
  return call("poseOf", frame, [&](Map& map) {
    const Status status = map.poseOf(frame, T_world_camera);
    if (!status.isOk() || T_world_camera.matrix().allFinite()) return status;
    return Status::failed("the pose is not finite");
  });
}

Status MapStage::graph(MapGraph& graph) {
  return call("graph", -1, [&](Map& map) {
    const Status status = map.graph(graph);
    return status.isOk() ? checkGraph(graph) : status;
  });
}

}  // namespace tolman::host
