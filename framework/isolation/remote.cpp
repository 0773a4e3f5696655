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
    case Call::Watch:
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
  if (created_) return std::nullopt;
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
  created_ = true;
  return std::nullopt;
}

bool Remote::enableRestart() {
  const bool remembers =
      manifest_.role == Role::Place || manifest_.role == Role::Cells || manifest_.role == Role::Map;
  restart_ = manifest_.role != Role::Source && (has_state_ || !remembers);
  if (restart_) worker_->keepRequests();
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
  if (worker_->gone()) {
    // An observer that dies at the beginning would be called without one ever after.
    if (call == Call::Begin) restart_ = false;
    return mourn(status);
  }
  keep(call);
  return status;
}

/// Notes how the process ended; the failure says what comes next.
Status Remote::mourn(const Status& status) {
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

/// A plugin that cannot save its state after all goes on, but cannot be restarted.
void Remote::checkpoint() {
  std::string state;
  const Status status =
      worker_->ask(Call::Save, kNothing, [&](Decoder& decoder) { decoder.get(state); });
  since_.clear();
  if (status.isOk()) {
    checkpoint_ = std::move(state);
    return;
  }
  restart_ = false;
  log_->warning("its state cannot be saved, so it will not be restarted: " + status.message());
  if (worker_->gone()) (void)mourn(status);
}

/// A failure of the plugin's own among the calls since the checkpoint was one before, too; only the
/// death of the process counts. In the beginning all went well.
Status Remote::replay(const std::vector<Kept>& calls) {
  for (const Kept& kept : calls) {
    Status status = worker_->ask(
        kept.call, [&](Encoder& encoder) { encoder.append(kept.request); },
        [](Decoder& decoder) { decoder.skip(); });
    if (worker_->gone() || (belongsToTheBeginning(kept.call) && !status.isOk())) return status;
  }
  return Status::ok();
}

Status Remote::rebuild() {
  created_ = false;
  auto refusal = load();
  worker_->serve(nullptr, cancellation_);  // what is logged now was logged before
  if (!refusal) refusal = create();
  if (refusal) return Status::failed(refusal->message);
  Status status = replay(beginning_);
  if (status.isOk() && !checkpoint_.empty()) {
    status = worker_->ask(
        Call::Restore, [&](Encoder& encoder) { encoder.put(checkpoint_); }, kNothing);
  }
  return status.isOk() ? replay(since_) : status;
}

Status Remote::revive() {
  ++restarts_;
  const Status status = rebuild();
  if (!status.isOk()) {
    worker_->abandon();  // half a plugin is none
    return mourn(Status::failed("a new process did not get far: " + status.message()));
  }
  worker_->keepRequests();
  worker_->serve(log_, cancellation_);
  amnesia_ = !has_state_;
  log_->warning(
      fmt::format("a new process has taken over ({} of {} restarts)", restarts_, kMostRestarts));
  return Status::ok();
}

Status Remote::destroy() {
  if (worker_->gone()) return Status::ok();  // that was reported when it happened
  restart_ = false;
  return call(Call::Destroy, std::tuple<>(), std::tuple<>());
}

}  // namespace tolman::isolation
