// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/stimulus.hpp"

#include <cstring>
#include <numbers>

#include "conformance/room.hpp"
#include "tolman/context.hpp"

namespace tolman::conformance {
namespace {

constexpr std::int64_t kFirstNs = 1'000'000'000;
constexpr std::int64_t kStepNs = 100'000'000;
constexpr int kPlaces = 24;  // views that a circle is divided into

Matrix6d covariance(double translation, double rotation) {
  Vector6d diagonal;
  diagonal << Eigen::Vector3d::Constant(translation * translation),
      Eigen::Vector3d::Constant(rotation * rotation);
  return diagonal.asDiagonal();
}

CameraRig rigOf(const StimulusOptions& options) {
  CameraRig rig;
  rig.width = options.width;
  rig.height = options.height;
  rig.calibrated = true;
  rig.pinhole = {0.75 * options.width, 0.75 * options.width, 0.5 * (options.width - 1),
                 0.5 * (options.height - 1)};
  rig.baseline = options.stereo ? 0.3 : 0;
  return rig;
}

/// Drives the circle and says at each frame what sound stages would.
class Drive {
 public:
  explicit Drive(const StimulusOptions& options)
      : options_(options), random_(options.seed), room_(options.seed) {
    stimulus_.rig = rigOf(options);
  }

  Stimulus make() {
    for (int k = 0; k < options_.frames; ++k) {
      Moment moment;
      T_world_camera_ = Room::poseAt(angle(k));
      look(k, moment.frame);
      move(k, moment.motion);
      recognise(k, moment.place);
      decide(moment.place, moment.decision);
      place(moment);
      moment.cells = {{"bump", {8}, std::vector<float>(8, 0.125F)}};
      stimulus_.moments.push_back(std::move(moment));
    }
    if (options_.frames > 2) stimulus_.last_revisions = {revision(options_.frames - 2)};
    stimulus_.graph = graph_;
    return std::move(stimulus_);
  }

 private:
  double angle(int k) const { return 2 * std::numbers::pi * k / options_.turn; }

  template <class R>
  void stamp(int k, R& record) const {
    record.frame = k;
    record.stamp_ns = kFirstNs + k * kStepNs;
  }

  void look(int k, Frame& frame) const {
    stamp(k, frame);
    frame.source_index = k;
    frame.has_truth = true;
    frame.T_world_camera_truth = T_world_camera_;
    measure(k, frame);
    if (!options_.images) return;
    const CameraRig& rig = stimulus_.rig;
    frame.left = room_.view(T_world_camera_, rig, 0, options_.format);
    if (options_.stereo) {
      frame.right = room_.view(T_world_camera_, rig, rig.baseline, options_.format);
    }
  }

  /// What a wheel odometer and a list of loops would say, under the names that replaying plugins
  /// read: motion since the frame before (m, m, rad), frames of an earlier round at the same place.
  void measure(int k, Frame& frame) const {
    const PlanarPose before = toPlanar(Room::poseAt(angle(std::max(k - 1, 0))));
    const PlanarPose moved = between(before, toPlanar(T_world_camera_));
    const auto f = [](auto value) { return static_cast<float>(value); };
    frame.sensors.push_back({"motion.planar", {3}, {f(moved.x), f(moved.y), f(moved.theta)}});
    NamedArray alike{"place.candidate", {0, 4}, {}};
    if (k >= options_.turn) {
      alike.shape[0] = 1;
      alike.values = {f(k - options_.turn), 0, 0, 0};
    }
    frame.sensors.push_back(std::move(alike));
  }

  Eigen::Isometry3d step(int k) {
    Vector6d noise;
    for (double& x : noise) x = 0.002 * random_.normal();
    return Room::poseAt(angle(k - 1)).inverse() * Room::poseAt(angle(k)) * expSe3(noise);
  }

  void move(int k, Motion& motion) {
    stamp(k, motion);
    if (k == 0) return;
    motion.state = TrackingState::Tracking;
    motion.T_previous_current = step(k);
    motion.covariance = covariance(0.01, 0.002);
    setPlanarVelocity(motion, 1e-9 * kStepNs);
    motion.tracked = 100;
    motion.is_keyframe = k % 4 == 0;
    if (options_.images) measureDepth(k, motion);
    if (k % 5 == 0) motion.revisions = {revision(k - 1)};
  }

  MotionRevision revision(int k) { return {k, step(k), covariance(0.008, 0.0015)}; }

  void measureDepth(int k, Motion& motion) const {
    constexpr int kColumns = 16;
    constexpr int kRows = 6;
    motion.points_frame = k;
    motion.points.resize(4, kColumns * kRows);
    for (int i = 0; i < kColumns * kRows; ++i) {
      const int row = i / kColumns;
      const Eigen::Vector2d pixel((i % kColumns + 0.5) * options_.width / kColumns,
                                  (row + 0.5) * options_.height / kRows);
      const double depth = Room::depth(T_world_camera_, stimulus_.rig, pixel);
      motion.points.col(i) << pixel.cast<float>(), static_cast<float>(1 / depth), 1e-4F;
    }
  }

  void recognise(int k, PlaceObservation& seen) {
    stamp(k, seen);
    const int view = static_cast<int>(static_cast<std::int64_t>(k) * kPlaces / options_.turn);
    const bool novel = view >= made_ && view < kPlaces;
    if (novel) angle_of_template_.push_back(angle(k));
    made_ = static_cast<int>(angle_of_template_.size());
    seen.recognition = novel ? Recognition::Novel : Recognition::Familiar;
    seen.template_id = view % kPlaces;
    const double then = angle_of_template_[static_cast<std::size_t>(seen.template_id)];
    seen.relative_yaw = wrapAngle(angle(k) - then);
    seen.score = novel ? 0 : 0.02 + 0.01 * random_.uniform();
    seen.has_relative_pose = !novel && k % 2 == 0;
    if (!seen.has_relative_pose) return;
    seen.T_template_current = Room::poseAt(then).inverse() * T_world_camera_;
    seen.covariance = covariance(0.05, 0.01);
  }

  void decide(const PlaceObservation& seen, Decision& decision) {
    stamp(static_cast<int>(seen.frame), decision);
    decision.experience = decision.template_id = seen.template_id;  // one experience a view
    const bool back = seen.template_id != last_view_;
    last_view_ = seen.template_id;
    decision.action = seen.recognition == Recognition::Novel ? Action::CreateExperience
                      : back                                 ? Action::CloseLoop
                                                             : Action::Stay;
    decision.relative_yaw = seen.relative_yaw;
    decision.has_relative_pose = seen.has_relative_pose;
    decision.T_experience_current = seen.T_template_current;
    decision.covariance = seen.covariance;
    decision.heading = wrapPeriod(angle(static_cast<int>(seen.frame)), 2 * std::numbers::pi);
    decision.confidence = 0.9;
  }

  void place(Moment& moment) {
    const Decision& decision = moment.decision;
    if (decision.action == Action::CreateExperience) {
      graph_.experiences.push_back(
          {decision.experience, decision.frame, decision.template_id, T_world_camera_});
    }
    if (decision.action != Action::Stay && at_ >= 0) link(decision);
    at_ = decision.experience;
    const auto& experience = graph_.experiences[static_cast<std::size_t>(at_)];
    stamp(static_cast<int>(decision.frame), moment.map);
    moment.map.experience = at_;
    moment.map.T_world_camera = T_world_camera_;
    moment.map.T_experience_camera = experience.T_world_experience.inverse() * T_world_camera_;
    moment.map.version = graph_.version;
    moment.map.experiences = static_cast<std::int64_t>(graph_.experiences.size());
    moment.map.links = static_cast<std::int64_t>(graph_.links.size());
    moment.map.loops = graph_.version;
    if (decision.action != Action::Stay) moment.graph = graph_;
  }

  void link(const Decision& decision) {
    const bool loop = decision.action == Action::CloseLoop;
    if (loop) ++graph_.version;
    const auto pose = [&](std::int64_t id) {
      return graph_.experiences[static_cast<std::size_t>(id)].T_world_experience;
    };
    Link link{static_cast<std::int64_t>(graph_.links.size()), at_, decision.experience,
              loop ? LinkKind::Loop : LinkKind::Odometry, decision.frame};
    link.T_from_to = pose(at_).inverse() * pose(decision.experience);
    link.covariance = covariance(0.05, 0.01);
    link.duration = loop ? 0 : 1e-9 * kStepNs;
    graph_.links.push_back(link);
  }

  StimulusOptions options_;
  RandomStream random_;
  Room room_;
  Stimulus stimulus_;
  MapGraph graph_;
  Eigen::Isometry3d T_world_camera_ = Eigen::Isometry3d::Identity();
  std::vector<double> angle_of_template_;
  int made_ = 0;
  std::int64_t last_view_ = -1;
  std::int64_t at_ = -1;
};

}  // namespace

StimulusOptions optionsFor(Role role, std::uint64_t seed) {
  StimulusOptions options;
  options.seed = seed;
  switch (role) {
    case Role::Source:  // gives its own frames
      options.frames = 8;
      options.images = false;
      break;
    case Role::Place:
      options.frames = 40;
      options.turn = 30;
      break;
    case Role::Cells:
    case Role::Map:
      options.frames = 150;
      options.turn = 60;
      options.images = false;
      break;
    default:
      break;
  }
  return options;
}

Stimulus makeStimulus(const StimulusOptions& options) { return Drive(options).make(); }

Stimulus shortened(Stimulus stimulus, std::size_t count) {
  if (stimulus.moments.size() > count) stimulus.moments.resize(count);
  stimulus.last_revisions.clear();
  return stimulus;
}

}  // namespace tolman::conformance
