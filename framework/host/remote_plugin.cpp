// SPDX-License-Identifier: BSD-3-Clause
#include "host/remote_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <new>
#include <utility>

#include "host/child_process.hpp"

namespace tolman::host {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kPollInterval{20};  // for cancellation and deadline
constexpr std::uint64_t kMaxReplyMib = 1U << 16U;
constexpr milliseconds kExitTimeout{500};  // for a process that has closed its socket
/// Sent at the deadline, before the process is killed: an interpreter can write where it was.
constexpr int kDeadlineSignal = SIGUSR2;

}  // namespace

ProcessHandle::ProcessHandle(LaunchOptions launch)
    : launch_(std::move(launch)), socket_(FileDescriptor()) {
  auto [ours, theirs] = Socket::pair();
  std::vector<std::string> command = launch_.command;
  command.push_back(std::to_string(theirs.descriptor()));
  process_ = std::make_unique<ChildProcess>(command, std::vector{theirs.descriptor()});
  socket_ = std::move(ours);
}

void ProcessHandle::connect(Logger* log, FindingCollector* findings,
                            const Cancellation* cancellation) {
  log_ = log;
  findings_ = findings;
  cancellation_ = cancellation;
}

Status ProcessHandle::call(Call call, const Write& write, const Read& read) {
  Encoder encoder;
  write(encoder);
  SocketMessage message{static_cast<std::uint32_t>(call), ++call_number_, encoder.take()};
  const bool is_sent = socket_.send(message);
  if (record_requests_) recorded_request_ = std::move(message.bytes);
  if (!is_sent) return readExit();
  const auto begin = steady_clock::now();
  try {
    for (;;) {
      const ReceiveResult received = waitForMessage(message, begin);
      if (received == ReceiveResult::Closed) return readExit();
      if (received == ReceiveResult::Timeout) {
        process_->signal(kDeadlineSignal);
        (void)process_->end(kExitTimeout);
        return end(fmt::format("did not return within {:g} s and was killed", launch_.deadline_s));
      }
      const auto kind = static_cast<ReplyKind>(message.kind);
      // Other numbers are from a copy of the process that the plugin made by fork().
      if (kind == ReplyKind::Reply && message.detail == call_number_) {
        return readReply(message.bytes, read);
      }
      if (kind == ReplyKind::Finding && findings_ != nullptr) {
        findings_->add(Decoder(message.bytes).next<Finding>());
      } else if (kind == ReplyKind::Log && log_ != nullptr) {
        log_->write(static_cast<LogLevel>(message.detail), message.bytes);
      }
    }
  } catch (const std::exception& error) {
    return end(std::string("sent a malformed reply and was killed: ") + error.what());
  }
}

/// Returns Timeout if the deadline of the call has passed.
ReceiveResult ProcessHandle::waitForMessage(SocketMessage& message,
                                            steady_clock::time_point begin) {
  const std::uint64_t most_mib = launch_.memory_mib > 0 ? launch_.memory_mib : kMaxReplyMib;
  for (;;) {
    const std::chrono::duration<double> waited = steady_clock::now() - begin;
    if (launch_.deadline_s > 0 && waited.count() > launch_.deadline_s) {
      return ReceiveResult::Timeout;
    }
    if (!cancel_sent_ && cancellation_ != nullptr && cancellation_->requested()) {
      cancel_sent_ = socket_.send({static_cast<std::uint32_t>(Call::Cancel), 0, {}});
    }
    // Processes that the plugin started may keep the socket open, so test the process as well. Test
    // it before the socket, which may still contain its last messages.
    const bool ended = process_->hasEnded();
    const ReceiveResult received =
        socket_.receive(message, ended ? milliseconds(0) : kPollInterval, most_mib << 20U);
    if (received != ReceiveResult::Timeout) return received;
    if (ended) return ReceiveResult::Closed;
  }
}

Status ProcessHandle::readReply(const std::string& reply, const Read& read) {
  Decoder decoder(reply);
  Status status = decoder.next<Status>();
  if (status.isOk()) read(decoder);
  if (decoder.remaining() > 0) throw std::domain_error("bytes follow its end");
  const bool out_of_memory = status.message().find("std::bad_alloc") != std::string::npos;
  if (!out_of_memory || launch_.memory_mib == 0) return status;
  return {status.code(),
          status.message() + fmt::format("; isolation.memory_limit is {} MiB", launch_.memory_mib)};
}

Status ProcessHandle::readExit() { return end(process_->end(kExitTimeout).text()); }

Status ProcessHandle::end(const std::string& reason) {
  exit_reason_ = reason;
  (void)process_->end(milliseconds(0));
  return Status::failed("its process " + reason);
}

namespace {

constexpr int kMaxRestarts = 10;
constexpr int kCheckpointEvery = 20;  // calls; a call with images takes about 1 MB

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

/// The file that the user wrote: the program, or the library.
std::string openedFile(const Manifest& manifest) {
  return (manifest.program.empty() ? manifest.file : manifest.program).string();
}

Refusal noProcess(const std::string& plugin, const std::string& why) {
  return {kNoProcess, "no process for plugin '" + plugin + "': " + why,
          "this is no defect of the plugin: raise the limits of processes, threads and open files "
          "(`ulimit -u`, `ulimit -n`), or end other programs"};
}

}  // namespace

std::shared_ptr<RemotePlugin> RemotePlugin::start(const Manifest& manifest,
                                                  const LaunchOptions& launch) {
  std::shared_ptr<RemotePlugin> remote(new RemotePlugin(manifest, launch));
  remote->load();
  return remote;
}

void RemotePlugin::load() {
  try {
    process_ = std::make_unique<ProcessHandle>(launch_);
  } catch (const std::exception& error) {
    throw noProcess(manifest_.id, error.what());
  }
  const LoadMessage message{manifest_.file.string(), manifest_.id, manifest_.program.string(),
                            launch_.memory_mib, launch_.threads};
  Refusal refusal;  // an empty id means success
  const Status status = process_->call(
      Call::Load, [&](Encoder& encoder) { encoder.put(message); },
      [&](Decoder& decoder) {
        decoder.getAll(refusal, manifest_.role, manifest_.version, manifest_.summary,
                       manifest_.program_files, schema_);
        if (enumName(manifest_.role) == "invalid")
          throw std::domain_error("a role that does not exist");
      });
  if (!status.isOk()) throw diedWhenOpened(status.message());
  if (!refusal.id.empty()) throw refusal;
}

/// Of a program its own file is to blame, not the library that interprets it.
Refusal RemotePlugin::diedWhenOpened(const std::string& why) const {
  if (!manifest_.program.empty()) {
    return {"plugin/program", openedFile(manifest_) + ": while it was imported: " + why,
            "what stands outside of functions runs at import: move long or dangerous work to "
            "start(); `tolman plugins doctor FILE` opens it alone"};
  }
  return {"plugin/died", openedFile(manifest_) + ": while the library was opened: " + why,
          "`tolman plugins validate FILE` shows more; static constructors of the library run when "
          "it is opened, within `isolation.deadline` and `isolation.memory_limit`"};
}

void RemotePlugin::create() {
  if (created_) return;
  Refusal refusal;
  const Status status = process_->call(Call::Create, kNoData, [&](Decoder& decoder) {
    decoder.getAll(refusal, has_arrays_, has_state_);
  });
  if (!status.isOk()) {
    throw Refusal{"plugin/create-failed",
                  "plugin '" + manifest_.id + "', construct: " + status.message(),
                  "a constructor must be cheap: move work to configure()"};
  }
  if (!refusal.id.empty()) throw refusal;
  created_ = true;
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
  return call(Call::Configure, message);
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
  const auto forget = [this] {
    std::erase_if(history_, [](const RecordedCall& one) { return !isInitial(one.call); });
  };
  if (call == Call::Reset) {
    forget();
  } else if (isInitial(call) || (changesState(call) && has_state_)) {
    history_.push_back({call, process_->lastRequest()});
  }
  const auto since = std::ranges::count_if(
      history_, [](const RecordedCall& one) { return changesState(one.call); });
  if (since < kCheckpointEvery) return;
  std::string state;
  const Status status =
      process_->call(Call::Save, kNoData, [&](Decoder& decoder) { decoder.get(state); });
  forget();
  history_.push_back({Call::Restore, std::move(state)});
  if (status.isOk()) return;
  restart_enabled_ = false;
  log_->warning("its state cannot be saved, so it will not be restarted: " + status.message());
}

/// Calls since the checkpoint may fail, because they failed before; those before may not.
Status RemotePlugin::startAndRestore() {
  created_ = false;
  try {
    load();
    process_->connect(nullptr, nullptr, cancellation_);  // the repeated calls were logged before
    create();
  } catch (const Refusal& refusal) {
    return Status::failed(refusal.message);
  }
  for (const RecordedCall& recorded : history_) {
    Status status = process_->call(
        recorded.call,
        [&](Encoder& encoder) {
          if (recorded.call == Call::Restore) return encoder.put(recorded.request);
          encoder.append(recorded.request);
        },
        [](Decoder& decoder) { decoder.skip(); });
    const bool must_succeed = !changesState(recorded.call);
    if (process_->hasEnded() || (must_succeed && !status.isOk())) return status;
  }
  return Status::ok();
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
  return call(Call::Destroy);
}

}  // namespace tolman::host
