// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/test_instance.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>

#include "host/stages.hpp"

namespace tolman::conformance {

namespace {

template <class Stage>
class InstanceOf : public TestInstance {
 public:
  InstanceOf(const PluginUnderTest& plugin, std::unique_ptr<host::Instance> instance)
      : TestInstance(plugin), stage_(std::move(instance)) {}
  ~InstanceOf() override { (void)destroy(); }

 protected:
  host::Instance& instance() override { return stage_.instance(); }
  void checkLocalised() override {
    if constexpr (requires { stage_.localise(); }) stage_.localise();
  }
  void resetChecks() override {
    if constexpr (requires { stage_.resetChecks(now_.count); }) {
      stage_.resetChecks(now_.count);
    } else if constexpr (requires { stage_.resetChecks(); }) {
      stage_.resetChecks();
    }
  }
  Status answerEnd(const InputSequence&, TranscriptEntry&) override {
    if constexpr (requires { stage_.finish(); }) return stage_.finish();
    return Status::ok();
  }
  Stage stage_;
};

class SourceInstance final : public InstanceOf<host::SourceStage> {
 public:
  using InstanceOf::InstanceOf;
  Status answer(const FrameInput&, TranscriptEntry& answer) override {
    if (!std::exchange(is_begun_, true)) {
      if (Status status = stage_.info(info_); !status.isOk()) return status;
      answer.add(info_.rig);
      answer.addValue("description", info_.description);
    }
    Frame frame;
    const Status status = stage_.next(frame);
    if (status.code() == StatusCode::EndOfStream) return checked("next", -1, checkEnd(status));
    if (!status.isOk()) return status;
    ++now_.count;
    answer.add(frame);
    return Status::ok();
  }

 private:
  Status checkEnd(const Status& end) const {
    if (info_.frames < 0 || info_.frames == now_.count) return end;
    return Status::failed("info() announced " + std::to_string(info_.frames) +
                          " frames, but next() gave " + std::to_string(now_.count));
  }
  SourceInfo info_;
};

class OdometryInstance final : public InstanceOf<host::OdometryStage> {
 public:
  using InstanceOf::InstanceOf;
  Status answer(const FrameInput& input, TranscriptEntry& answer) override {
    Motion motion;
    const Status status = stage_.track(input.frame, motion);
    answer.add(motion);
    return status;
  }
  Status answerEnd(const InputSequence&, TranscriptEntry& answer) override {
    std::vector<MotionRevision> revisions;
    const Status status = stage_.finish(revisions);
    answer.addValue("revisions", revisions);
    return status;
  }
};

class PlaceInstance final : public InstanceOf<host::PlaceStage> {
 public:
  using InstanceOf::InstanceOf;
  Status answer(const FrameInput& input, TranscriptEntry& answer) override {
    const bool wants_motion = stage_.input() == PlaceInput::FrameAndMotion;
    PlaceObservation seen;
    const Status status = stage_.observe(input.frame, wants_motion ? &input.motion : nullptr, seen);
    answer.add(seen);
    reached_.name = "familiar views";
    if (!status.isOk()) return status;
    if (seen.recognition == Recognition::Familiar) ++reached_.count;
    if (seen.recognition == Recognition::Novel) ++now_.count;
    return status;
  }
};

class CellsInstance final : public InstanceOf<host::CellsStage> {
 public:
  using InstanceOf::InstanceOf;
  Status answer(const FrameInput& input, TranscriptEntry& answer) override {
    Decision decision;
    const Status status = stage_.step(input.motion, input.place, decision);
    answer.add(decision);
    reached_.name = "loops closed";
    if (!status.isOk()) return status;
    if (decision.action == Action::CreateExperience) ++now_.count;
    if (decision.action == Action::CloseLoop) ++reached_.count;
    return status;
  }
};

class MapInstance final : public InstanceOf<host::MapStage> {
 public:
  using InstanceOf::InstanceOf;
  Status answer(const FrameInput& input, TranscriptEntry& answer) override {
    MapUpdate update;
    Status status = stage_.update(input.motion, input.decision, update);
    answer.add(update);
    MapGraph graph;
    if (status.isOk()) status = stage_.graph(graph);
    if (status.isOk()) status = stage_.checkLastPose();
    if (!status.isOk()) return status;
    reached_ = {"loop links", update.loops};
    now_.frames.push_back(input.frame.frame);
    return checkUnseen(input.frame.frame + 1'000'000);
  }
  Status answerEnd(const InputSequence& sequence, TranscriptEntry& answer) override {
    Status status = stage_.finish(sequence.last_revisions);
    MapGraph graph;
    if (status.isOk()) status = stage_.graph(graph);
    answer.addValue("experiences", graph.experiences);
    answer.addValue("links", graph.links);
    std::map<std::int64_t, Eigen::Isometry3d> poses;
    for (const std::int64_t frame : now_.frames) {
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

 private:
  Status checkUnseen(std::int64_t frame) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    if (stage_.poseOf(frame, T).code() == StatusCode::InvalidParameter) return Status::ok();
    return checked("poseOf", frame,
                   Status::failed("a frame that was never given must be InvalidParameter"));
  }
};

class ObserverInstance final : public InstanceOf<host::ObserverStage> {
 public:
  using InstanceOf::InstanceOf;
  Status answer(const FrameInput& input, TranscriptEntry&) override {
    if (Status status = callBegin(); !status.isOk()) return status;
    return stage_.observe({&input.frame, &input.motion, &input.place, &input.decision, &input.map,
                           &input.cells, input.graph ? &*input.graph : nullptr});
  }
  Status answerEnd(const InputSequence& sequence, TranscriptEntry&) override {
    const Status status = callBegin();
    return status.isOk() ? stage_.finish(sequence.graph) : status;
  }

 private:
  Status callBegin() {
    if (std::exchange(is_begun_, true)) return Status::ok();
    return stage_.begin(
        {"conformance", plugin_.scratch.string(), {"synthetic room", rig_, -1, true}, {}});
  }
};

template <class Role>
std::unique_ptr<TestInstance> makeInstance(const PluginUnderTest& plugin,
                                           std::unique_ptr<host::Instance> instance) {
  return std::make_unique<Role>(plugin, std::move(instance));
}

/// Services of the context that ignore everything.
struct NoServices final : Logger, FindingCollector, ArtefactWriter, Cancellation, Clock {
  void write(LogLevel, std::string_view) override {}
  void add(Finding) override {}
  Status write(std::string_view, std::span<const std::byte>) override { return Status::ok(); }
  bool requested() const override { return false; }
  std::int64_t steadyNs() const override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  }
} services;

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

std::unique_ptr<TestInstance> TestInstance::make(const PluginUnderTest& plugin,
                                                 ParameterValues values) {
  constexpr std::array kMakers = {&makeInstance<SourceInstance>, &makeInstance<OdometryInstance>,
                                  &makeInstance<PlaceInstance>,  &makeInstance<CellsInstance>,
                                  &makeInstance<MapInstance>,    &makeInstance<ObserverInstance>};
  plugin.trace("construct");
  auto created = host::Instance::create(plugin.loaded, std::string(enumName(plugin.role())));
  auto instance = kMakers.at(static_cast<std::size_t>(plugin.role()))(plugin, std::move(created));
  instance->values_ = std::move(values);
  return instance;
}

Status TestInstance::checked(std::string_view call, std::int64_t frame, const Status& status) {
  return host::guarded({instance().name(), instance().manifest().id, call, frame},
                       [&] { return status; });
}

Status TestInstance::configure(const CameraRig& rig, bool localise) {
  plugin_.trace("configure");
  const bool is_source = plugin_.role() == Role::Source;
  const Context context{values_,
                        services,
                        services,
                        services,
                        services,
                        services,
                        is_source ? CameraRig() : rig,
                        plugin_.seed,
                        instance().name(),
                        localise};
  rig_ = rig;
  const Status status = instance().configure(context);
  if (status.isOk()) beginRun();
  if (localise) checkLocalised();
  return status;
}

void TestInstance::beginRun() {
  now_ = {};
  is_begun_ = false;
  frames_ = 0;
  ended_ = false;
  resetChecks();
}

void TestInstance::continueRun(const TestInstance& other) {
  now_ = other.now_;
  resetChecks();
}

Status TestInstance::reset() {
  plugin_.trace("reset");
  const Status status = instance().reset();
  beginRun();
  return status;
}

Status TestInstance::appendArrays(std::int64_t frame, TranscriptEntry& answer) {
  std::vector<NamedArray> arrays;
  const Status status = instance().arrays(frame, arrays);
  for (const NamedArray& array : arrays) answer.addValue(array.name, array);
  return status;
}

Status TestInstance::process(const FrameInput& input) {
  const bool source = plugin_.role() == Role::Source;
  const std::int64_t frame = source ? frames_ : input.frame.frame;
  TranscriptEntry entry;
  entry.call = "frame " + std::to_string(frame);
  plugin_.trace(entry.call);
  Status status = answer(input, entry);
  if (status.code() == StatusCode::EndOfStream) {
    ended_ = true;
    return status;
  }
  if (status.isOk()) status = appendArrays(frame, entry);
  ++frames_;
  if (status.isOk()) transcript_.push_back(std::move(entry));
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
  const Status status = answerEnd(sequence, answer);
  if (status.isOk()) transcript_.push_back(std::move(answer));
  return status;
}

Status TestInstance::destroy() {
  plugin_.trace("destroy");
  return instance().destroy();
}

Result<std::string> TestInstance::save() {
  plugin_.trace("save");
  return instance().save();
}

Status TestInstance::load(const std::string& state) {
  plugin_.trace("load");
  return instance().load(state);
}

}  // namespace tolman::conformance
