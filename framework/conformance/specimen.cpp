// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/specimen.hpp"

#include <chrono>

namespace tolman::conformance {

/// What a Context refers to: all that a plugin says goes nowhere.
struct Actor::Services final : Logger, ArtefactWriter, Cancellation, Clock {
  void write(LogLevel, std::string_view) override {}
  Status write(std::string_view, std::span<const std::byte>) override { return Status::ok(); }
  bool requested() const override { return false; }
  std::int64_t steadyNs() const override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  }
};

Actor::Actor(const Specimen& specimen, ParameterValues values)
    : specimen_(specimen), values_(std::move(values)), services_(std::make_unique<Services>()) {
  specimen_.trace("construct");
  auto created =
      plugins::Instance::create(specimen_.plugin, std::string(enumName(specimen.role())));
  if (const auto* refusal = std::get_if<plugins::Refusal>(&created)) {
    created_ = Status::failed(refusal->message);
    return;
  }
  driver_ =
      makeDriver(specimen.role(), std::move(std::get<std::unique_ptr<plugins::Instance>>(created)),
                 specimen_.scratch.string());
}

Actor::~Actor() { (void)destroy(); }

Status Actor::configure(const CameraRig& rig) {
  if (!created_.isOk()) return created_;
  specimen_.trace("configure");
  const Context context{values_,        *services_,
                        *services_,     *services_,
                        *services_,     specimen_.role() == Role::Source ? CameraRig() : rig,
                        specimen_.seed, driver_->instance().name(),
                        false,          true};
  driver_->setRig(rig);
  const Status status = driver_->instance().configure(context);
  if (status.isOk()) driver_->begin();
  return status;
}

Status Actor::reset() {
  specimen_.trace("reset");
  const Status status = driver_->instance().reset();
  startAfresh();
  return status;
}

void Actor::startAfresh() {
  driver_->begin();
  frames_ = 0;
  ended_ = false;
}

Status Actor::appendArrays(std::int64_t frame, Answer& answer) {
  std::vector<NamedArray> arrays;
  const Status status = driver_->instance().arrays(frame, arrays);
  for (const NamedArray& array : arrays) answer.addValue(array.name, array);
  return status;
}

Status Actor::work(const Moment& moment) {
  const bool source = specimen_.role() == Role::Source;
  const std::int64_t frame = source ? frames_ : moment.frame.frame;
  Answer answer;
  answer.call = "frame " + std::to_string(frame);
  specimen_.trace(answer.call);
  Status status = driver_->work(moment, answer);
  if (status.code() == StatusCode::EndOfStream) {
    ended_ = true;
    return status;
  }
  if (status.isOk()) status = appendArrays(frame, answer);
  ++frames_;
  if (status.isOk()) transcript_.push_back(std::move(answer));
  return status;
}

Status Actor::run(const Stimulus& stimulus, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < std::min(last, stimulus.moments.size()); ++i) {
    Status status = work(stimulus.moments[i]);
    if (status.code() == StatusCode::EndOfStream) break;
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

Status Actor::finish(const Stimulus& stimulus) {
  Answer answer;
  answer.call = "finish";
  specimen_.trace(answer.call);
  const Status status = driver_->finish(stimulus, answer);
  if (status.isOk()) transcript_.push_back(std::move(answer));
  return status;
}

Status Actor::destroy() {
  if (!driver_) return Status::ok();
  specimen_.trace("destroy");
  const Status status = driver_->instance().destroy();
  driver_.reset();
  return status;
}

bool Actor::keepsState() const { return driver_ && driver_->instance().state() != nullptr; }

Status Actor::save(std::ostream& stream) {
  specimen_.trace("save");
  return driver_->instance().call<Plugin>(
      "save", -1, [&](Plugin&) { return driver_->instance().state()->save(stream); });
}

Status Actor::load(std::istream& stream) {
  specimen_.trace("load");
  return driver_->instance().call<Plugin>(
      "load", -1, [&](Plugin&) { return driver_->instance().state()->load(stream); });
}

}  // namespace tolman::conformance
