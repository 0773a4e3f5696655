// SPDX-License-Identifier: BSD-3-Clause
#include "host/remote_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host/library.hpp"
#include "host/plugin_process.hpp"

namespace tolman::host {
namespace {

constexpr int kMaxRestarts = 10;
constexpr std::size_t kCheckpointEvery = 20;  // calls; a call with images takes about 1 MB

const auto kNoData = [](auto&) {};

/// Calls that change the state of a plugin. Only they are repeated after a restart.
bool changesState(Call call) {
  constexpr std::array kChanging = {Call::Track,       Call::Observe,     Call::Step,
                                    Call::Update,      Call::Watch,       Call::FinishOdometry,
                                    Call::FinishPlace, Call::FinishCells, Call::FinishMap};
  return std::ranges::find(kChanging, call) != kChanging.end();
}

bool isInitial(Call call) {
  return call == Call::Configure || call == Call::OpenArtefacts || call == Call::Begin;
}

/// Addition to a remedy if the limits are below the defaults; otherwise empty.
std::string hintAt(const LaunchOptions& limits) {
  const LaunchOptions usual;
  std::string hint;
  if (limits.deadline_s > 0 && limits.deadline_s < usual.deadline_s) {
    hint += fmt::format("; isolation.deadline is {:g} s", limits.deadline_s);
  }
  if (limits.memory_mib > 0 && limits.memory_mib < usual.memory_mib) {
    hint += fmt::format("; isolation.memory_limit is {} MiB", limits.memory_mib);
  }
  return hint;
}

/// The file that the user wrote: the program, or the library.
std::string openedFile(const host::Manifest& manifest) {
  return (manifest.program.empty() ? manifest.file : manifest.program).string();
}

host::Refusal noProcess(const std::string& plugin, const std::string& why) {
  return {host::kNoProcess, "no process for plugin '" + plugin + "': " + why,
          "this is no defect of the plugin: raise the limits of processes, threads and open files "
          "(`ulimit -u`, `ulimit -n`), or end other programs"};
}

}  // namespace

host::OrRefusal<std::shared_ptr<RemotePlugin>> RemotePlugin::start(const host::Manifest& manifest,
                                                                   const LaunchOptions& launch) {
  std::shared_ptr<RemotePlugin> remote(new RemotePlugin(manifest, launch));
  if (auto refusal = remote->load()) return *refusal;
  return remote;
}

std::optional<host::Refusal> RemotePlugin::load() {
  try {
    process_ = std::make_unique<ProcessHandle>(launch_);
  } catch (const std::exception& error) {
    return noProcess(manifest_.id, error.what());
  }
  const LoadMessage message{manifest_.file.string(), manifest_.id, manifest_.program.string(),
                            launch_.memory_mib, launch_.threads};
  host::Refusal refusal;  // an empty id means success
  const Status status = process_->call(
      Call::Load, [&](Encoder& encoder) { encoder.put(message); },
      [&](Decoder& decoder) {
        decoder.getAll(refusal, manifest_.role, manifest_.version, manifest_.summary,
                       manifest_.program_files, schema_);
        if (enumName(manifest_.role) == "invalid")
          throw MalformedMessage("a role that does not exist");
      });
  const std::optional<int> exit_code = process_->exitCode();
  const std::string kind = manifest_.program.empty() ? "the library" : "the program";
  if (exit_code == kNoThreadsExit) return noProcess(manifest_.id, "its threads cannot be started");
  if (exit_code == kNoMemoryExit) {
    return host::Refusal{"plugin/load-failed",
                         openedFile(manifest_) + ": out of memory while " + kind + " was opened",
                         host::kLimitsTooLow + hintAt(launch_)};
  }
  if (!status.isOk()) return diedWhenOpened(status.message());
  if (!refusal.id.empty()) {
    refusal.remedy += hintAt(launch_);
    return refusal;
  }
  return std::nullopt;
}

/// Of a program its own file is to blame, not the library that interprets it.
host::Refusal RemotePlugin::diedWhenOpened(const std::string& why) const {
  if (!manifest_.program.empty()) {
    return {"plugin/program", openedFile(manifest_) + ": while it was imported: " + why,
            "what stands outside of functions runs at import: move long or dangerous work to "
            "start(); `tolman plugins doctor FILE` opens it alone" +
                hintAt(launch_)};
  }
  return {"plugin/died", openedFile(manifest_) + ": while the library was opened: " + why,
          "`tolman plugins validate FILE` shows more; static constructors of the library run when "
          "it is opened" +
              hintAt(launch_)};
}

std::optional<host::Refusal> RemotePlugin::create() {
  if (created_) return std::nullopt;
  host::Refusal refusal;
  const Status status = process_->call(Call::Create, kNoData, [&](Decoder& decoder) {
    decoder.getAll(refusal, has_arrays_, has_state_);
  });
  if (!status.isOk()) {
    return host::Refusal{"plugin/create-failed",
                         "plugin '" + manifest_.id + "', construct: " + status.message(),
                         "a constructor must be cheap: move work to configure()"};
  }
  if (!refusal.id.empty()) return refusal;
  created_ = true;
  return std::nullopt;
}

bool RemotePlugin::enableRestart() {
  const bool needs_state =
      manifest_.role == Role::Place || manifest_.role == Role::Cells || manifest_.role == Role::Map;
  restart_enabled_ = manifest_.role != Role::Source && (has_state_ || !needs_state);
  if (restart_enabled_) process_->recordRequests();
  return restart_enabled_;
}

Status RemotePlugin::configure(const Context& context) {
  log_ = &context.log;
  findings_ = &context.findings;
  cancellation_ = &context.cancellation;
  process_->connect(log_, findings_, cancellation_);
  const ContextMessage message = ContextMessage::of(context);
  return call(Call::Configure, std::tie(message), std::tuple<>());
}

Status RemotePlugin::exchange(Call call, const ProcessHandle::Write& write,
                              const ProcessHandle::Read& read) {
  if (process_->hasEnded()) {
    if (!canRestart()) {
      return Status::failed("its process has ended: it " + process_->exitReason());
    }
    Status status = restart();
    if (!status.isOk()) return status;
  }
  Status status = process_->call(call, write, read);
  if (!process_->hasEnded()) {
    record(call);
    return status;
  }
  // Without begin() an observer must not be called again.
  if (call == Call::Begin) restart_enabled_ = false;
  if (!canRestart()) return status;
  return {status.code(), status.message() + "; a new process will be started"};
}

void RemotePlugin::record(Call call) {
  if (!restart_enabled_) return;
  if (isInitial(call)) {
    initial_calls_.push_back({call, process_->lastRequest()});
  } else if (call == Call::Reset) {
    calls_since_checkpoint_.clear();
    checkpoint_.clear();
  } else if (changesState(call) && has_state_) {
    calls_since_checkpoint_.push_back({call, process_->lastRequest()});
    if (calls_since_checkpoint_.size() >= kCheckpointEvery) checkpoint();
  }
}

void RemotePlugin::checkpoint() {
  std::string state;
  const Status status =
      process_->call(Call::Save, kNoData, [&](Decoder& decoder) { decoder.get(state); });
  calls_since_checkpoint_.clear();
  if (status.isOk()) {
    checkpoint_ = std::move(state);
    return;
  }
  restart_enabled_ = false;
  log_->warning("its state cannot be saved, so it will not be restarted: " + status.message());
}

/// Repeats calls. Calls since the checkpoint may fail, because they failed before; initial calls
/// may not.
Status RemotePlugin::repeat(const std::vector<RecordedCall>& calls) {
  for (const RecordedCall& recorded : calls) {
    Status status = process_->call(
        recorded.call, [&](Encoder& encoder) { encoder.append(recorded.request); },
        [](Decoder& decoder) { decoder.skip(); });
    if (process_->hasEnded() || (isInitial(recorded.call) && !status.isOk())) return status;
  }
  return Status::ok();
}

Status RemotePlugin::startAndRestore() {
  created_ = false;
  auto refusal = load();
  process_->connect(nullptr, nullptr, cancellation_);  // the repeated calls were logged before
  if (!refusal) refusal = create();
  if (refusal) {
    return Status::failed(refusal->message);
  }
  Status status = repeat(initial_calls_);
  if (status.isOk() && !checkpoint_.empty()) {
    status = process_->call(
        Call::Restore, [&](Encoder& encoder) { encoder.put(checkpoint_); }, kNoData);
  }
  return status.isOk() ? repeat(calls_since_checkpoint_) : status;
}

Status RemotePlugin::restart() {
  ++restarts_;
  const Status status = startAndRestore();
  if (!status.isOk()) return process_->end("could not be restored: " + status.message());
  process_->recordRequests();
  process_->connect(log_, findings_, cancellation_);
  state_lost_ = !has_state_;
  log_->warning(
      fmt::format("a new process was started (restart {} of {})", restarts_, kMaxRestarts));
  return Status::ok();
}

bool RemotePlugin::canRestart() const { return restart_enabled_ && restarts_ < kMaxRestarts; }

Status RemotePlugin::destroy() {
  if (process_->hasEnded()) return Status::ok();  // already reported
  restart_enabled_ = false;
  return call(Call::Destroy, std::tuple<>(), std::tuple<>());
}

}  // namespace tolman::host
