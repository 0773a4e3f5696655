// SPDX-License-Identifier: BSD-3-Clause
// One driver a role: the host's stage, and the parts of the contract that need memory.
#include <optional>
#include <utility>

#include "conformance/contract.hpp"
#include "conformance/specimen.hpp"
#include "plugins/stages.hpp"

namespace tolman::conformance {
namespace {

/// Names the stage before what the kit found itself.
Status blame(plugins::Instance& instance, std::string_view call, std::int64_t frame,
             const Status& status) {
  return plugins::guarded({instance.name(), instance.manifest().id, call, frame},
                          [&] { return status; });
}

template <class Stage>
class DriverOf : public RoleDriver {
 public:
  explicit DriverOf(std::unique_ptr<plugins::Instance> instance) : stage_(std::move(instance)) {}
  plugins::Instance& instance() override { return stage_.instance(); }
  void begin() override {}
  void resume(const RoleDriver&) override {}

 protected:
  Status judged(std::string_view call, std::int64_t frame, const Status& status) {
    return status.isOk() ? status : blame(instance(), call, frame, status);
  }
  Stage stage_;
};

class SourceDriver final : public DriverOf<plugins::SourceStage> {
 public:
  using DriverOf::DriverOf;
  void begin() override {
    stage_.expect();
    next_ = last_ns_ = 0;
    informed_ = false;
  }
  void resume(const RoleDriver& other) override {
    const auto& source = static_cast<const SourceDriver&>(other);
    next_ = source.next_;
    last_ns_ = source.last_ns_;
    stage_.expect(next_, last_ns_);
  }
  Status work(const Moment&, Answer& answer) override {
    if (Status status = inform(answer); !status.isOk()) return status;
    Frame frame;
    const Status status = stage_.next(frame);
    if (status.code() == StatusCode::EndOfStream) return judged("next", -1, checkEnd(status));
    if (!status.isOk()) return status;
    ++next_;
    last_ns_ = frame.stamp_ns;
    answer.add(frame);
    const bool pair = info_.rig.isStereo() && frame.left.empty() != frame.right.empty();
    const bool silent = frame.left.empty() && info_.rig.width > 0 && frame.defect.empty();
    if (pair) {
      return judged("next", frame.frame,
                    Status::failed("one image of a pair is missing; give both or none"));
    }
    if (!silent) return Status::ok();
    return judged("next", frame.frame,
                  Status::failed("the image is missing and `defect` does not say why"));
  }
  Status finish(const Stimulus&, Answer&) override { return Status::ok(); }

 private:
  Status inform(Answer& answer) {
    if (std::exchange(informed_, true)) return Status::ok();
    const Status status = stage_.info(info_);
    answer.add(info_.rig);
    answer.addValue("description", info_.description);
    return status;
  }
  Status checkEnd(const Status& end) const {
    if (info_.frames < 0 || info_.frames == next_) return end;
    return Status::failed("info() promised " + std::to_string(info_.frames) + " frames, " +
                          std::to_string(next_) + " came");
  }
  SourceInfo info_;
  std::int64_t next_ = 0;
  std::int64_t last_ns_ = 0;
  bool informed_ = false;
};

class OdometryDriver final : public DriverOf<plugins::OdometryStage> {
 public:
  using DriverOf::DriverOf;
  void begin() override { previous_.reset(); }
  void resume(const RoleDriver& other) override {
    previous_ = static_cast<const OdometryDriver&>(other).previous_;
  }
  Status work(const Moment& moment, Answer& answer) override {
    Motion motion;
    Status status = stage_.track(moment.frame, motion);
    if (status.isOk()) {
      const Frame* previous = previous_ ? &*previous_ : nullptr;
      status = judged("track", moment.frame.frame, checkMotion(motion, moment.frame, previous));
    }
    previous_ = moment.frame;
    answer.add(motion);
    return status;
  }
  Status finish(const Stimulus&, Answer& answer) override {
    std::vector<MotionRevision> revisions;
    const Status status = stage_.finish(revisions);
    answer.addValue("revisions", revisions);
    return status.isOk() ? judged("finish", -1, checkRevisions(revisions)) : status;
  }

 private:
  std::optional<Frame> previous_;
};

class PlaceDriver final : public DriverOf<plugins::PlaceStage> {
 public:
  using DriverOf::DriverOf;
  void begin() override {
    stage_.expect();
    templates_ = 0;
  }
  void resume(const RoleDriver& other) override {
    templates_ = static_cast<const PlaceDriver&>(other).templates_;
    stage_.expect(templates_);
  }
  Status work(const Moment& moment, Answer& answer) override {
    const bool wants_motion = stage_.input() == PlaceInput::FrameAndMotion;
    PlaceObservation seen;
    const Status status =
        stage_.observe(moment.frame, wants_motion ? &moment.motion : nullptr, seen);
    answer.add(seen);
    if (!status.isOk()) return status;
    return judged("observe", moment.frame.frame, checkPlace(seen, templates_));
  }
  Status finish(const Stimulus&, Answer&) override { return stage_.finish(); }

 private:
  std::int64_t templates_ = 0;
};

class CellsDriver final : public DriverOf<plugins::CellsStage> {
 public:
  using DriverOf::DriverOf;
  void begin() override {
    stage_.expect();
    experiences_ = 0;
    at_ = -1;
  }
  void resume(const RoleDriver& other) override {
    const auto& cells = static_cast<const CellsDriver&>(other);
    experiences_ = cells.experiences_;
    at_ = cells.at_;
    stage_.expect(experiences_);
  }
  Status work(const Moment& moment, Answer& answer) override {
    Decision decision;
    const Status status = stage_.step(moment.motion, moment.place, decision);
    answer.add(decision);
    if (!status.isOk()) return status;
    if (decision.action == Action::CreateExperience) ++experiences_;
    const std::int64_t before = std::exchange(at_, decision.experience);
    return judged("step", moment.frame.frame, checkDecision(decision, before));
  }
  Status finish(const Stimulus&, Answer&) override { return stage_.finish(); }

 private:
  std::int64_t experiences_ = 0;
  std::int64_t at_ = -1;
};

class MapDriver final : public DriverOf<plugins::MapStage> {
 public:
  using DriverOf::DriverOf;
  void begin() override {
    version_ = 0;
    seen_.clear();
  }
  void resume(const RoleDriver& other) override {
    version_ = static_cast<const MapDriver&>(other).version_;
    seen_ = static_cast<const MapDriver&>(other).seen_;
  }
  Status work(const Moment& moment, Answer& answer) override {
    MapUpdate update;
    Status status = stage_.update(moment.motion, moment.decision, update);
    answer.add(update);
    MapGraph graph;
    if (status.isOk()) status = stage_.graph(graph);
    if (status.isOk()) {
      status = judged("update", moment.frame.frame, checkUpdate(update, graph, version_));
    }
    if (!status.isOk()) return status;
    version_ = update.version;
    seen_.push_back(moment.frame.frame);
    return checkPoses(moment.frame.frame, update.T_world_camera);
  }
  Status finish(const Stimulus& stimulus, Answer& answer) override {
    Status status = stage_.finish(stimulus.last_revisions);
    MapGraph graph;
    if (status.isOk()) status = stage_.graph(graph);
    answer.addValue("experiences", graph.experiences);
    answer.addValue("links", graph.links);
    for (std::size_t i = 0; status.isOk() && i < seen_.size(); ++i) {
      Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
      status = stage_.poseOf(seen_[i], T);
      answer.addValue("pose of frame " + std::to_string(seen_[i]), T);
    }
    return status;
  }

 private:
  /// A frame is where the update says; one that never came is refused.
  Status checkPoses(std::int64_t frame, const Eigen::Isometry3d& T_world_camera) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    if (Status status = stage_.poseOf(frame, T); !status.isOk()) return status;
    if (!close(T, T_world_camera)) {
      return judged("poseOf", frame, Status::failed("not the T_world_camera of the update"));
    }
    const Status unseen = stage_.poseOf(frame + 1'000'000, T);
    if (unseen.code() == StatusCode::InvalidParameter) return Status::ok();
    return judged("poseOf", frame + 1'000'000,
                  Status::failed("a frame that never came must be InvalidParameter"));
  }
  std::int64_t version_ = 0;
  std::vector<std::int64_t> seen_;
};

class ObserverDriver final : public DriverOf<plugins::ObserverStage> {
 public:
  ObserverDriver(std::unique_ptr<plugins::Instance> instance, std::string folder)
      : DriverOf(std::move(instance)), folder_(std::move(folder)) {}
  void begin() override { begun_ = false; }
  Status work(const Moment& moment, Answer&) override {
    if (Status status = beginRun(); !status.isOk()) return status;
    return stage_.observe({&moment.frame, &moment.motion, &moment.place, &moment.decision,
                           &moment.map, &moment.cells, moment.graph ? &*moment.graph : nullptr});
  }
  Status finish(const Stimulus& stimulus, Answer&) override {
    const Status status = beginRun();
    return status.isOk() ? stage_.finish(stimulus.graph) : status;
  }

 private:
  Status beginRun() {
    if (std::exchange(begun_, true)) return Status::ok();
    return stage_.begin({"conformance", folder_, {"a room, seen while driving", rig_, -1, true}});
  }
  std::string folder_;
  bool begun_ = false;
};

}  // namespace

std::unique_ptr<RoleDriver> makeDriver(Role role, std::unique_ptr<plugins::Instance> instance,
                                       const std::string& scratch) {
  switch (role) {
    case Role::Source:
      return std::make_unique<SourceDriver>(std::move(instance));
    case Role::Odometry:
      return std::make_unique<OdometryDriver>(std::move(instance));
    case Role::Place:
      return std::make_unique<PlaceDriver>(std::move(instance));
    case Role::Cells:
      return std::make_unique<CellsDriver>(std::move(instance));
    case Role::Map:
      return std::make_unique<MapDriver>(std::move(instance));
    case Role::Observer:
      break;
  }
  return std::make_unique<ObserverDriver>(std::move(instance), scratch);
}

}  // namespace tolman::conformance
