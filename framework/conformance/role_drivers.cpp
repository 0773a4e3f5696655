// SPDX-License-Identifier: BSD-3-Clause
// One driver per role.
#include <array>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "conformance/test_instance.hpp"
#include "host/stages.hpp"

namespace tolman::conformance {
namespace {

/// `Progress` is what the checks of a run need of its earlier frames.
template <class Stage, class Progress>
class DriverOf : public RoleDriver {
 public:
  /// `scratch`: folder for files of the plugin.
  DriverOf(std::unique_ptr<host::Instance> instance, std::string scratch)
      : stage_(std::move(instance)), scratch_(std::move(scratch)) {}
  host::Instance& instance() override { return stage_.instance(); }
  void beginRun() override {
    now_ = {};
    resetChecks();
  }
  void continueRun(const RoleDriver& other) override {
    now_ = static_cast<const DriverOf&>(other).now_;
    resetChecks();
  }

 protected:
  /// Sets the state of the host's own checks to the progress of the run.
  virtual void resetChecks() {}
  /// Adds the call site to a failure that the kit found.
  Status checked(std::string_view call, std::int64_t frame, const Status& status) {
    return host::guarded({instance().name(), instance().manifest().id, call, frame},
                         [&] { return status; });
  }
  Stage stage_;
  Progress now_;
  std::string scratch_;
};

struct SourceProgress {
  std::int64_t next = 0;
  std::int64_t last_ns = 0;
};

class SourceDriver final : public DriverOf<host::SourceStage, SourceProgress> {
 public:
  using DriverOf::DriverOf;
  void beginRun() override {
    DriverOf::beginRun();
    has_info_ = false;
  }
  Status process(const FrameInput&, TranscriptEntry& answer) override {
    if (Status status = readInfo(answer); !status.isOk()) return status;
    Frame frame;
    const Status status = stage_.next(frame);
    if (status.code() == StatusCode::EndOfStream) return checked("next", -1, checkEnd(status));
    if (!status.isOk()) return status;
    ++now_.next;
    now_.last_ns = frame.stamp_ns;
    answer.add(frame);
    const bool pair = info_.rig.isStereo() && frame.left.empty() != frame.right.empty();
    const bool unexplained = frame.left.empty() && info_.rig.width > 0 && frame.defect.empty();
    if (pair) {
      return checked("next", frame.frame,
                     Status::failed("one image of a pair is missing; give both or none"));
    }
    if (!unexplained) return Status::ok();
    return checked("next", frame.frame,
                   Status::failed("the image is missing and `defect` does not say why"));
  }
  Status finish(const InputSequence&, TranscriptEntry&) override { return Status::ok(); }

 private:
  void resetChecks() override { stage_.resetChecks(now_.next, now_.last_ns); }
  Status readInfo(TranscriptEntry& answer) {
    if (std::exchange(has_info_, true)) return Status::ok();
    const Status status = stage_.info(info_);
    answer.add(info_.rig);
    answer.addValue("description", info_.description);
    return status;
  }
  Status checkEnd(const Status& end) const {
    if (info_.frames < 0 || info_.frames == now_.next) return end;
    return Status::failed("info() announced " + std::to_string(info_.frames) +
                          " frames, but next() gave " + std::to_string(now_.next));
  }
  SourceInfo info_;
  bool has_info_ = false;
};

/// Remembers the previous frame.
class OdometryDriver final : public DriverOf<host::OdometryStage, std::optional<Frame>> {
 public:
  using DriverOf::DriverOf;
  Status process(const FrameInput& input, TranscriptEntry& answer) override {
    Motion motion;
    Status status = stage_.track(input.frame, motion);
    if (status.isOk()) {
      const Frame* previous = now_ ? &*now_ : nullptr;
      status = checked("track", input.frame.frame, checkDt(motion, input.frame, previous));
    }
    now_ = input.frame;
    answer.add(motion);
    return status;
  }
  Status finish(const InputSequence&, TranscriptEntry& answer) override {
    std::vector<MotionRevision> revisions;
    const Status status = stage_.finish(revisions);
    answer.addValue("revisions", revisions);
    return status;
  }

 private:
  void resetChecks() override { stage_.resetChecks(); }
};

/// Counts the templates.
class PlaceDriver final : public DriverOf<host::PlaceStage, std::int64_t> {
 public:
  using DriverOf::DriverOf;
  Status process(const FrameInput& input, TranscriptEntry& answer) override {
    const bool wants_motion = stage_.input() == PlaceInput::FrameAndMotion;
    PlaceObservation seen;
    const Status status = stage_.observe(input.frame, wants_motion ? &input.motion : nullptr, seen);
    answer.add(seen);
    if (!status.isOk()) return status;
    if (seen.recognition == Recognition::Familiar) ++familiar_;
    if (seen.recognition == Recognition::Novel) ++now_;
    return status;
  }
  Status finish(const InputSequence&, TranscriptEntry&) override { return stage_.finish(); }
  Measurement reached() const override { return {"familiar views", familiar_, ""}; }

 private:
  void resetChecks() override { stage_.resetChecks(now_); }
  double familiar_ = 0;
};

/// Counts the experiences.
class CellsDriver final : public DriverOf<host::CellsStage, std::int64_t> {
 public:
  using DriverOf::DriverOf;
  Status process(const FrameInput& input, TranscriptEntry& answer) override {
    Decision decision;
    const Status status = stage_.step(input.motion, input.place, decision);
    answer.add(decision);
    if (!status.isOk()) return status;
    if (decision.action == Action::CreateExperience) ++now_;
    if (decision.action == Action::CloseLoop) ++loops_;
    return status;
  }
  Status finish(const InputSequence&, TranscriptEntry&) override { return stage_.finish(); }
  Measurement reached() const override { return {"loops closed", loops_, ""}; }

 private:
  void resetChecks() override { stage_.resetChecks(now_); }
  double loops_ = 0;
};

/// Remembers the frames.
class MapDriver final : public DriverOf<host::MapStage, std::vector<std::int64_t>> {
 public:
  using DriverOf::DriverOf;
  Status process(const FrameInput& input, TranscriptEntry& answer) override {
    MapUpdate update;
    Status status = stage_.update(input.motion, input.decision, update);
    answer.add(update);
    MapGraph graph;
    if (status.isOk()) status = stage_.graph(graph);
    if (!status.isOk()) return status;
    loops_ = static_cast<double>(update.loops);
    now_.push_back(input.frame.frame);
    return checkPoses(input.frame.frame, update.T_world_camera);
  }
  Status finish(const InputSequence& sequence, TranscriptEntry& answer) override {
    Status status = stage_.finish(sequence.last_revisions);
    MapGraph graph;
    if (status.isOk()) status = stage_.graph(graph);
    answer.addValue("experiences", graph.experiences);
    answer.addValue("links", graph.links);
    std::map<std::int64_t, Eigen::Isometry3d> poses;
    for (const std::int64_t frame : now_) {
      if (!status.isOk()) return status;
      Eigen::Isometry3d& T = poses[frame] = Eigen::Isometry3d::Identity();
      status = stage_.poseOf(frame, T);
      answer.addValue("pose of frame " + std::to_string(frame), T);
    }
    if (!status.isOk()) return status;
    return stage_.checkExperiences(graph, [&](std::int64_t frame) {
      const auto found = poses.find(frame);
      return found == poses.end() ? nullptr : &found->second;
    });
  }
  Measurement reached() const override { return {"loop links", loops_, ""}; }

 private:
  void resetChecks() override { stage_.resetChecks(); }
  /// Checks that poseOf() gives a frame the pose of its update, and refuses an unknown frame.
  Status checkPoses(std::int64_t frame, const Eigen::Isometry3d& T_world_camera) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    if (Status status = stage_.poseOf(frame, T); !status.isOk()) return status;
    if (!close(T, T_world_camera)) {
      return checked("poseOf", frame, Status::failed("not the T_world_camera of the update"));
    }
    const Status unseen = stage_.poseOf(frame + 1'000'000, T);
    if (unseen.code() == StatusCode::InvalidParameter) return Status::ok();
    return checked("poseOf", frame + 1'000'000,
                   Status::failed("a frame that was never given must be InvalidParameter"));
  }
  double loops_ = 0;
};

class ObserverDriver final : public DriverOf<host::ObserverStage, std::monostate> {
 public:
  using DriverOf::DriverOf;
  void beginRun() override { begin_called_ = false; }
  Status process(const FrameInput& input, TranscriptEntry&) override {
    if (Status status = callBegin(); !status.isOk()) return status;
    return stage_.observe({&input.frame, &input.motion, &input.place, &input.decision, &input.map,
                           &input.cells, input.graph ? &*input.graph : nullptr});
  }
  Status finish(const InputSequence& sequence, TranscriptEntry&) override {
    const Status status = callBegin();
    return status.isOk() ? stage_.finish(sequence.graph) : status;
  }

 private:
  Status callBegin() {
    if (std::exchange(begin_called_, true)) return Status::ok();
    return stage_.begin({"conformance", scratch_, {"synthetic room", rig_, -1, true}, {}});
  }
  bool begin_called_ = false;
};

template <class Driver>
std::unique_ptr<RoleDriver> make(std::unique_ptr<host::Instance> instance,
                                 const std::string& scratch) {
  return std::make_unique<Driver>(std::move(instance), scratch);
}

}  // namespace

std::unique_ptr<RoleDriver> makeDriver(Role role, std::unique_ptr<host::Instance> instance,
                                       const std::string& scratch) {
  constexpr std::array kMakers = {&make<SourceDriver>, &make<OdometryDriver>,
                                  &make<PlaceDriver>,  &make<CellsDriver>,
                                  &make<MapDriver>,    &make<ObserverDriver>};
  return kMakers.at(static_cast<std::size_t>(role))(std::move(instance), scratch);
}

}  // namespace tolman::conformance
