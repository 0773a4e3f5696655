// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/test_instance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tolman::conformance {

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
  driver_ = makeDriver(plugin.role(), std::move(std::get<std::unique_ptr<host::Instance>>(created)),
                       plugin_.scratch.string());
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
  driver_->setRig(rig);
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

}  // namespace tolman::conformance
