// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/test_instance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <variant>

#include "host/stages.hpp"

namespace tolman::conformance {

/// Calls one instance in its role, through the host's guarded stage, and checks answers against
/// those of earlier frames.
class RoleDriver {
 public:
  virtual ~RoleDriver() = default;
  /// One frame. A source ignores the input and gives its next frame.
  virtual Status process(const FrameInput& input, TranscriptEntry& answer) = 0;
  virtual Status finish(const InputSequence& sequence, TranscriptEntry& answer) = 0;
  /// Expects a new run: after configure() or reset().
  virtual void beginRun() = 0;
  /// Expects the run of `other` to continue here: its state was loaded into this instance.
  virtual void continueRun(const RoleDriver& other) = 0;
  virtual host::Instance& instance() = 0;
  /// Number of events that need a long drive, such as closed loops; an empty name for roles without
  /// such events.
  virtual Measurement reached() const { return {}; }

  CameraRig rig{};        ///< of the source of the run
  std::string scratch{};  ///< folder for files of the plugin
};

bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).norm() < 1e-6 * (1 + a.translation().norm());
}

Status checkDt(const Motion& motion, const Frame& frame, const Frame* previous) {
  const std::int64_t passed_ns = previous ? frame.stamp_ns - previous->stamp_ns : 0;
  const double expected = 1e-9 * static_cast<double>(passed_ns);
  if (std::abs(motion.dt - expected) < 1e-6) return Status::ok();
  return Status::failed(fmt::format("dt is {:f} s, the stamps say {:f} s; see setPlanarVelocity()",
                                    motion.dt, expected));
}

namespace {

/// `Progress` is what the checks of a run need of its earlier frames.
template <class Stage, class Progress>
class DriverOf : public RoleDriver {
 public:
  explicit DriverOf(std::unique_ptr<host::Instance> instance) : stage_(std::move(instance)) {}
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
    return Status::ok();
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
    return stage_.begin({"conformance", scratch, {"synthetic room", rig, -1, true}, {}});
  }
  bool begin_called_ = false;
};

template <class Driver>
std::unique_ptr<RoleDriver> make(std::unique_ptr<host::Instance> instance) {
  return std::make_unique<Driver>(std::move(instance));
}

std::unique_ptr<RoleDriver> makeDriver(Role role, std::unique_ptr<host::Instance> instance) {
  constexpr std::array kMakers = {&make<SourceDriver>, &make<OdometryDriver>,
                                  &make<PlaceDriver>,  &make<CellsDriver>,
                                  &make<MapDriver>,    &make<ObserverDriver>};
  return kMakers.at(static_cast<std::size_t>(role))(std::move(instance));
}

}  // namespace

std::optional<std::string> firstDifference(const Transcript& expected, const Transcript& found,
                                           std::size_t skip) {
  const std::size_t count = expected.size() - std::min(skip, expected.size());
  for (std::size_t i = 0; i < std::min(count, found.size()); ++i) {
    const TranscriptEntry& wanted = expected[skip + i];
    const TranscriptEntry& given = found[i];
    if (wanted.call != given.call) return "'" + given.call + "' instead of '" + wanted.call + "'";
    for (std::size_t f = 0; f < std::max(wanted.fields.size(), given.fields.size()); ++f) {
      if (f >= wanted.fields.size() || f >= given.fields.size())
        return wanted.call + ": its length";
      if (wanted.fields[f] != given.fields[f]) {
        return wanted.call + ": '" + wanted.fields[f].first + "'";
      }
    }
  }
  if (count == found.size()) return std::nullopt;
  return std::to_string(found.size()) + " answers instead of " + std::to_string(count);
}

/// Services of the context that ignore everything.
struct TestInstance::Services final : Logger,
                                      FindingCollector,
                                      ArtefactWriter,
                                      Cancellation,
                                      Clock {
  void write(LogLevel, std::string_view) override {}
  void add(Finding) override {}
  Status write(std::string_view, std::span<const std::byte>) override { return Status::ok(); }
  bool requested() const override { return false; }
  std::int64_t steadyNs() const override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  }
};

TestInstance::TestInstance(const PluginUnderTest& plugin, ParameterValues values)
    : plugin_(plugin), values_(std::move(values)), services_(std::make_unique<Services>()) {
  plugin_.trace("construct");
  auto created = host::Instance::create(plugin_.loaded, std::string(enumName(plugin.role())));
  if (const auto* refusal = std::get_if<host::Refusal>(&created)) {
    created_ = Status::failed(refusal->message);
    return;
  }
  driver_ =
      makeDriver(plugin.role(), std::move(std::get<std::unique_ptr<host::Instance>>(created)));
  driver_->scratch = plugin_.scratch.string();
}

TestInstance::~TestInstance() { (void)destroy(); }

Status TestInstance::configure(const CameraRig& rig) {
  if (!created_.isOk()) return created_;
  plugin_.trace("configure");
  const bool is_source = plugin_.role() == Role::Source;
  const Context context{values_,
                        *services_,
                        *services_,
                        *services_,
                        *services_,
                        *services_,
                        is_source ? CameraRig() : rig,
                        plugin_.seed,
                        driver_->instance().name()};
  driver_->rig = rig;
  const Status status = driver_->instance().configure(context);
  if (status.isOk()) driver_->beginRun();
  return status;
}

Status TestInstance::reset() {
  plugin_.trace("reset");
  const Status status = driver_->instance().reset();
  beginRun();
  return status;
}

void TestInstance::beginRun() {
  driver_->beginRun();
  frames_ = 0;
  ended_ = false;
}

Status TestInstance::appendArrays(std::int64_t frame, TranscriptEntry& answer) {
  std::vector<NamedArray> arrays;
  const Status status = driver_->instance().arrays(frame, arrays);
  for (const NamedArray& array : arrays) answer.addValue(array.name, array);
  return status;
}

Status TestInstance::process(const FrameInput& input) {
  const bool source = plugin_.role() == Role::Source;
  const std::int64_t frame = source ? frames_ : input.frame.frame;
  TranscriptEntry answer;
  answer.call = "frame " + std::to_string(frame);
  plugin_.trace(answer.call);
  Status status = driver_->process(input, answer);
  if (status.code() == StatusCode::EndOfStream) {
    ended_ = true;
    return status;
  }
  if (status.isOk()) status = appendArrays(frame, answer);
  ++frames_;
  if (status.isOk()) transcript_.push_back(std::move(answer));
  return status;
}

Status TestInstance::run(const InputSequence& sequence, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < std::min(last, sequence.inputs.size()); ++i) {
    Status status = process(sequence.inputs[i]);
    if (status.code() == StatusCode::EndOfStream) break;
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

Status TestInstance::finish(const InputSequence& sequence) {
  TranscriptEntry answer;
  answer.call = "finish";
  plugin_.trace(answer.call);
  const Status status = driver_->finish(sequence, answer);
  if (status.isOk()) transcript_.push_back(std::move(answer));
  return status;
}

Status TestInstance::destroy() {
  if (!driver_) return Status::ok();
  plugin_.trace("destroy");
  const Status status = driver_->instance().destroy();
  driver_.reset();
  return status;
}

bool TestInstance::keepsState() const { return driver_ && driver_->instance().state() != nullptr; }

Status TestInstance::save(std::ostream& stream) {
  plugin_.trace("save");
  return driver_->instance().call<Plugin>(
      "save", -1, [&](Plugin&) { return host::saveTo(stream, *driver_->instance().state()); });
}

Status TestInstance::load(std::istream& stream) {
  plugin_.trace("load");
  return driver_->instance().call<Plugin>(
      "load", -1, [&](Plugin&) { return driver_->instance().state()->load(stream); });
}

Measurement TestInstance::reached() const { return driver_->reached(); }

void TestInstance::continueRun(const TestInstance& other) { driver_->continueRun(*other.driver_); }

}  // namespace tolman::conformance
