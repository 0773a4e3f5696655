// SPDX-License-Identifier: BSD-3-Clause
#include "experience_map.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

#include "saved_map.hpp"

namespace tolman::experience_map {
namespace {

constexpr int kOnlineIterations = 5;  // of one correction; chosen, not tuned
// Relative change of the energy that ends a correction. Chosen, not tuned.
constexpr double kOnlineTolerance = 1e-6;
// More than needed: twice or half as many give the same results on all available drives.
constexpr int kFinalIterations = 100;
constexpr double kFinalTolerance = 1e-10;  // relative change of the energy; chosen, not tuned

}  // namespace

Status ExperienceMap::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  log_ = &context.log;
  findings_ = &context.findings;
  return reset();
}

Status ExperienceMap::reset() {
  motions_ = DeadReckoning(parameters_);
  chain_ = ExperienceChain(parameters_);
  version_ = 0;
  next_correction_ = 0;
  return Status::ok();
}

Status ExperienceMap::update(const Motion& motion, const Decision& decision, MapUpdate& update) {
  if (Status status = check(motion, decision); !status.isOk()) return status;
  revise(motion.revisions);
  if (motions_.size() == 0) chain_.start();
  motions_.append(motion, chain_.current());
  if (motions_[motions_.last()].gap) startPart();
  applyDecision(decision);
  insertEarlier(decision.earlier);
  if (correctionDue()) correct();
  report(update);
  return Status::ok();
}

Status ExperienceMap::check(const Motion& motion, const Decision& decision) const {
  if (Status status = motions_.check(motion); !status.isOk()) return status;
  const std::int64_t known = chain_.experiences();
  const std::string id = std::to_string(decision.experience);
  if (decision.frame != motion.frame) {
    return Status::invalidInput("the decision is of frame " + std::to_string(decision.frame) +
                                ", but the motion of frame " + std::to_string(motion.frame));
  }
  if (decision.action == Action::CreateExperience && decision.experience != known) {
    return Status::invalidInput("the decision creates experience " + id + ", but the next is " +
                                std::to_string(known) + "; ids are 0, 1, 2, ... without gaps");
  }
  const std::int64_t least = decision.action == Action::CloseLoop ? 0 : -1;
  const bool unknown = decision.experience < least || decision.experience >= known;
  if (decision.action != Action::CreateExperience && unknown) {
    return Status::invalidInput("the decision (" + std::string(enumName(decision.action)) +
                                ") names experience " + id + ", but there are only " +
                                std::to_string(known));
  }
  for (const EarlierLoop& loop : decision.earlier) {
    if (Status status = check(loop); !status.isOk()) return status;
  }
  return Status::ok();
}

/// The experience of a loop must exist, and must have existed at the loop's frame.
Status ExperienceMap::check(const EarlierLoop& loop) const {
  const bool known = loop.experience >= 0 && loop.experience < chain_.experiences();
  const std::optional<std::size_t> slot = motions_.slotOf(loop.frame);
  if (known && (!slot || *slot > chain_.slotOf(loop.experience))) return Status::ok();
  return Status::invalidInput("the decision has a loop of frame " + std::to_string(loop.frame) +
                              " to experience " + std::to_string(loop.experience) +
                              ", which did not exist then");
}

/// Called after the decision of this frame is applied, because that may join parts of the path.
void ExperienceMap::insertEarlier(const std::vector<EarlierLoop>& loops) {
  std::size_t unknown = 0;
  for (const EarlierLoop& loop : loops) {
    const std::optional<std::size_t> slot = motions_.slotOf(loop.frame);
    if (slot) {
      chain_.insertVisit(motions_, *slot, loop.experience,
                         {loop.T_experience_camera, loop.covariance});
    } else {
      ++unknown;
    }
  }
  warnOfUnknown(unknown, "loops");
}

void ExperienceMap::revise(const std::vector<MotionRevision>& revisions) {
  if (revisions.empty()) return;
  std::size_t unknown = 0;
  const std::size_t first = motions_.revise(revisions, unknown);
  warnOfUnknown(unknown, "revisions");
  if (first == motions_.size()) return;
  chain_.refresh(motions_, first);
  ++version_;
}

void ExperienceMap::warnOfUnknown(std::size_t count, const char* what) const {
  if (count == 0) return;
  log_->warning("ignored " + std::to_string(count) + " " + what +
                " of frames that the map did not get");
}

void ExperienceMap::startPart() {
  chain_.startPart(motions_);
  log_->info("frame " + std::to_string(motions_[motions_.last()].frame) +
             ": tracking restarted at an unknown pose; a new part of the map begins");
}

void ExperienceMap::applyDecision(const Decision& decision) {
  const bool already_there =
      decision.experience >= 0 && chain_[chain_.current()].experience == decision.experience;
  if (decision.action == Action::CreateExperience) {
    chain_.addExperience(motions_, decision.template_id);
  } else if (decision.action == Action::CloseLoop && decision.has_relative_pose) {
    chain_.addVisit(motions_, decision.experience,
                    {decision.T_experience_current, decision.covariance});
  } else if (decision.action == Action::CloseLoop && !already_there) {
    chain_.addVisit(motions_, decision.experience, decision.relative_yaw);
  }  // a loop to the current experience without measured pose adds no information
  motions_.moveTo(motions_.last(), chain_.current());
}

bool ExperienceMap::correctionDue() const {
  return parameters_.optimise && chain_.pending() && motions_.last() >= next_correction_;
}

void ExperienceMap::correct() {
  noteCorrection(chain_.correct(motions_, kOnlineIterations, kOnlineTolerance));
  // The time of a correction grows with the number of nodes. The interval grows in proportion,
  // which bounds the mean time per frame.
  const auto growth = parameters_.interval_growth * static_cast<double>(chain_.current());
  next_correction_ = motions_.last() + static_cast<std::size_t>(parameters_.interval) +
                     static_cast<std::size_t>(growth);
}

void ExperienceMap::noteCorrection(const Status& status) {
  if (status.isOk()) {
    ++version_;
  } else {
    log_->warning("the map is not corrected, because the optimiser failed: " + status.message());
  }
}

void ExperienceMap::report(MapUpdate& update) const {
  const ReckonedFrame& last = motions_[motions_.last()];
  update.frame = last.frame;
  update.stamp_ns = last.stamp_ns;
  update.T_world_camera = chain_.T_world_camera(motions_, motions_.last());
  const ExperiencePose place = chain_.experiencePose(motions_, motions_.last());
  update.experience = place.experience;
  update.T_experience_camera = place.T_experience_camera;
  update.version = version_;
  update.experiences = chain_.experiences();
  update.links = chain_.links();
  update.loops = chain_.loops();
}

Status ExperienceMap::poseOf(std::int64_t frame, Eigen::Isometry3d& T_world_camera) const {
  const std::optional<std::size_t> slot = motions_.slotOf(frame);
  if (!slot) {
    return Status::invalidParameter("the map has not seen frame " + std::to_string(frame));
  }
  T_world_camera = chain_.T_world_camera(motions_, *slot);
  return Status::ok();
}

Status ExperienceMap::graph(MapGraph& graph) const {
  graph.version = version_;
  chain_.graph(motions_, graph);
  return Status::ok();
}

Status ExperienceMap::save(std::ostream& stream) const {
  return saveMap(motions_, chain_, {version_, next_correction_}, stream);
}

Status ExperienceMap::load(std::istream& stream) {
  if (Status status = reset(); !status.isOk()) return status;
  MapCounters counters;
  if (Status status = loadMap(stream, motions_, chain_, counters); !status.isOk()) return status;
  version_ = counters.version;
  next_correction_ = counters.next_correction;
  return Status::ok();
}

/// What was learned about odometry, and how far the loops are from the map.
void ExperienceMap::reportErrors() const {
  constexpr double kFar = 3;             // standard deviations
  constexpr std::size_t kFewestFar = 3;  // fewer are chance; chosen, not tuned
  for (const std::string& sentence : describe(chain_.calibration())) log_->info(sentence);
  std::vector<double> residuals = chain_.residuals();
  if (residuals.empty()) return;
  std::ranges::sort(residuals);
  const auto quantile = [&](double share) {
    return residuals[static_cast<std::size_t>(share * static_cast<double>(residuals.size() - 1))];
  };
  std::ostringstream text;
  text << std::setprecision(2) << "loop links are " << quantile(0.5)
       << " standard deviations from the map (median; 95 %: " << quantile(0.95) << ")";
  log_->info(text.str());
  const auto far =
      static_cast<std::size_t>(residuals.end() - std::ranges::upper_bound(residuals, kFar));
  if (far < kFewestFar || 10 * far < residuals.size()) return;
  findings_->add({Finding::Severity::Warning, "map",
                  std::to_string(far) + " of " + std::to_string(residuals.size()) +
                      " loop links are more than three standard deviations from the map: " +
                      causeOfResiduals(),
                  "see where the lines between experiences are long in the report's map; give the "
                  "cells fewer look-alikes, or the views the errors that they have"});
}

/// What the learned errors say of loops that do not fit.
std::string ExperienceMap::causeOfResiduals() const {
  constexpr double kNoisier = 1.7;  // times; chosen, not tuned
  const Assumptions& learned = chain_.assumptions();
  const std::int64_t rejected = chain_.rejected();
  if (10 * rejected > chain_.loops()) {
    return std::to_string(rejected) + " further ones are rejected as false, and these may be too";
  }
  if (std::max(learned.loop_distance, learned.loop_turns) > kNoisier) {
    return "the poses that views measure are less certain than they say";
  }
  if (std::max(learned.odometry_distance, learned.odometry_turns) > kNoisier) {
    return "odometry is noisier than it says, or its errors change on the way";
  }
  return "the map is wrong there, or the views are of other places";
}

Status ExperienceMap::finish(const std::vector<MotionRevision>& revisions) {
  revise(revisions);
  if (!parameters_.optimise || !chain_.visited()) return Status::ok();
  noteCorrection(chain_.correctFinally(motions_, kFinalIterations, kFinalTolerance));
  reportErrors();
  return Status::ok();
}

}  // namespace tolman::experience_map
