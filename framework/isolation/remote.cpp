// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/remote.hpp"

#include <fmt/format.h>

#include <utility>

namespace tolman::isolation {
namespace {

constexpr int kMostRestarts = 10;
constexpr std::size_t kCheckpointEvery = 20;  // calls: with images about 1 MB each

const auto kNothing = [](auto&) {};

plugins::Refusal refusalOf(const RefusalMessage& message) {
  return {message.id, message.message, message.remedy};
}

/// Calls after which a plugin is another than before. Only they must be repeated.
bool changesState(Call call) {
  switch (call) {
    case Call::Track:
    case Call::Observe:
    case Call::Step:
    case Call::Update:
    case Call::FinishOdometry:
    case Call::FinishPlace:
    case Call::FinishCells:
    case Call::FinishMap:
      return true;
    default:
      return false;
  }
}

bool belongsToTheBeginning(Call call) {
  return call == Call::Configure || call == Call::OpenArtefacts || call == Call::Begin;
}

}  // namespace

plugins::OrRefusal<std::shared_ptr<Remote>> Remote::start(const plugins::Manifest& manifest,
                                                          const Launch& launch) {
  std::shared_ptr<Remote> remote(new Remote(manifest, launch));
  if (auto refusal = remote->load()) return *refusal;
  return remote;
}

std::optional<plugins::Refusal> Remote::load() {
  try {
    worker_ = std::make_unique<Worker>(launch_);
  } catch (const std::exception& error) {
    return plugins::Refusal{"plugin/no-process",
                            "no process for plugin '" + manifest_.id + "': " + error.what(),
                            "run without `isolation: process`, or end other programs"};
  }
  const LoadMessage message{manifest_.file.string(), manifest_.id, launch_.memory_mib,
                            launch_.threads};
  RefusalMessage refusal;
  const Status status = worker_->ask(
      Call::Load, [&](Encoder& encoder) { encoder.put(message); },
      [&](Decoder& decoder) { decoder.getAll(refusal, schema_); });
  if (!status.isOk()) {
    return plugins::Refusal{
        "plugin/died",
        manifest_.file.string() + ": while the library was opened: " + status.message(),
        "`tolman plugins validate FILE` shows more; static constructors of the library run there"};
  }
  if (!refusal.id.empty()) return refusalOf(refusal);
  return std::nullopt;
}

std::optional<plugins::Refusal> Remote::create() {
  RefusalMessage refusal;
  const Status status = worker_->ask(Call::Create, kNothing, [&](Decoder& decoder) {
    decoder.getAll(refusal, has_arrays_, has_state_);
  });
  if (!status.isOk()) {
    return plugins::Refusal{"plugin/create-failed",
                            "plugin '" + manifest_.id + "', construct: " + status.message(),
                            "a constructor must be cheap: move work to configure()"};
  }
  if (!refusal.id.empty()) return refusalOf(refusal);
  return std::nullopt;
}

bool Remote::enableRestart() {
  const bool remembers =
      manifest_.role == Role::Place || manifest_.role == Role::Cells || manifest_.role == Role::Map;
  restart_ = manifest_.role != Role::Source && (has_state_ || !remembers);
  return restart_;
}

Status Remote::configure(const Context& context) {
  log_ = &context.log;
  cancellation_ = &context.cancellation;
  worker_->serve(log_, cancellation_);
  const ContextMessage message = ContextMessage::of(context);
  return call(Call::Configure, std::tie(message), std::tuple<>());
}

Status Remote::exchange(Call call, const Worker::Write& write, const Worker::Read& read) {
  if (worker_->gone()) {
    if (!restart_ || restarts_ >= kMostRestarts) {
      return Status::failed("its process is gone, since it " + epitaph_);
    }
    Status status = revive();
    if (!status.isOk()) return status;
  }
  Status status = worker_->ask(call, write, read);
  if (!worker_->gone()) {
    keep(call);
    return status;
  }
  constexpr std::string_view kSubject = "its process ";
  const std::string& what = status.message();
  epitaph_ = what.starts_with(kSubject) ? what.substr(kSubject.size()) : what;
  if (!restart_ || restarts_ >= kMostRestarts) return status;
  return {status.code(), what + "; a new process takes over"};
}

void Remote::keep(Call call) {
  if (!restart_) return;
  if (belongsToTheBeginning(call)) {
    beginning_.push_back({call, worker_->lastRequest()});
  } else if (call == Call::Reset) {
    since_.clear();
    checkpoint_.clear();
  } else if (changesState(call) && has_state_) {
    since_.push_back({call, worker_->lastRequest()});
    if (since_.size() >= kCheckpointEvery) checkpoint();
  }
}

void Remote::checkpoint() {
  std::string state;
  const Status status =
      worker_->ask(Call::Save, kNothing, [&](Decoder& decoder) { decoder.get(state); });
  if (!status.isOk()) return;  // the older one and the calls since then still serve
  checkpoint_ = std::move(state);
  since_.clear();
}

Status Remote::replay(const std::vector<Kept>& calls) {
  for (const Kept& kept : calls) {
    Status status = worker_->ask(
        kept.call, [&](Encoder& encoder) { encoder.append(kept.request); }, kNothing);
    if (worker_->gone()) return status;
  }
  return Status::ok();
}

/// A failure of the plugin's own in here was one before, too: only the death of the process counts.
Status Remote::revive() {
  ++restarts_;
  auto refusal = load();
  if (!refusal) refusal = create();
  if (refusal) return Status::failed("a new process cannot be started: " + refusal->message);
  Status status = replay(beginning_);
  if (status.isOk() && !checkpoint_.empty()) {
    status = worker_->ask(
        Call::Restore, [&](Encoder& encoder) { encoder.put(checkpoint_); }, kNothing);
  }
  if (status.isOk()) status = replay(since_);
  if (!status.isOk()) return Status::failed("a new process did not get far: " + status.message());
  worker_->serve(log_, cancellation_);
  amnesia_ = !has_state_;
  log_->warning(fmt::format("process {} of {} has taken over", restarts_ + 1, kMostRestarts + 1));
  return Status::ok();
}

Status Remote::destroy() {
  if (worker_->gone()) return Status::ok();  // that was reported when it happened
  restart_ = false;
  return call(Call::Destroy, std::tuple<>(), std::tuple<>());
}

}  // namespace tolman::isolation
