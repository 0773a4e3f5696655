// SPDX-License-Identifier: BSD-3-Clause
#include "host/process_handle.hpp"

#include <fmt/format.h>

#include <new>

#include "host/calls.hpp"

namespace tolman::host {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kPollInterval{20};  // for cancellation and deadline
constexpr std::uint64_t kMaxReplyMib = 1U << 16U;
constexpr milliseconds kExitTimeout{500};  // for a process that has closed its socket

}  // namespace

ProcessHandle::ProcessHandle(LaunchOptions launch)
    : launch_(std::move(launch)),
      request_("tolman-request"),
      response_("tolman-response"),
      control_memory_("tolman-control"),
      control_(new (control_memory_.reserve(sizeof(ControlBlock))) ControlBlock{}),
      socket_(Descriptor()) {
  auto [ours, theirs] = Socket::pair();
  const std::vector<int> passed = {theirs.descriptor(), request_.descriptor(),
                                   response_.descriptor(), control_memory_.descriptor(),
                                   stack_.descriptor()};
  std::vector<std::string> command = launch_.command;
  for (const int descriptor : passed) command.push_back(std::to_string(descriptor));
  process_ = std::make_unique<ChildProcess>(command, passed);
  socket_ = std::move(ours);
}

void ProcessHandle::connect(Logger* log, FindingCollector* findings,
                            const Cancellation* cancellation) {
  log_ = log;
  findings_ = findings;
  cancellation_ = cancellation;
}

Status ProcessHandle::call(Call call, const Write& write, const Read& read) {
  Encoder encoder(request_);
  write(encoder);
  SocketMessage message{{static_cast<std::uint32_t>(call), ++call_number_, encoder.size()}, {}};
  if (record_requests_) {  // before the call, because the process could overwrite shared memory
    recorded_request_.assign(reinterpret_cast<const char*>(request_.view(encoder.size())),
                             encoder.size());
  }
  if (!socket_.send(message)) return readExit();
  const auto begin = steady_clock::now();
  for (;;) {
    const ReceiveResult received = waitForMessage(message, begin);
    if (received == ReceiveResult::Closed) return readExit();
    if (received == ReceiveResult::Timeout) {
      return endAtDeadline();
    }
    if (message.kind == static_cast<std::uint32_t>(ReplyKind::Reply)) {
      if (message.detail == call_number_) return readReply(message, read);
      continue;  // from a copy of the process that the plugin made by fork()
    }
    if (message.kind == static_cast<std::uint32_t>(ReplyKind::Finding)) {
      const auto finding = findingOf(message.text);
      if (findings_ != nullptr && finding) findings_->add(*finding);
      continue;
    }
    if (log_ != nullptr && message.detail <= static_cast<std::uint32_t>(LogLevel::Error)) {
      log_->write(static_cast<LogLevel>(message.detail), message.text);
    }
  }
}

/// Returns Timeout if the deadline of the call has passed.
ReceiveResult ProcessHandle::waitForMessage(SocketMessage& message,
                                            steady_clock::time_point begin) {
  for (;;) {
    const std::chrono::duration<double> waited = steady_clock::now() - begin;
    if (launch_.deadline_s > 0 && waited.count() > launch_.deadline_s) {
      return ReceiveResult::Timeout;
    }
    const bool cancelled = cancellation_ != nullptr && cancellation_->requested();
    control_->cancelled.store(cancelled ? 1 : 0, std::memory_order_relaxed);
    // Processes that the plugin started may keep the socket open, so test the process as well. Test
    // it before the socket, which may still contain its last messages.
    const bool ended = process_->hasEnded();
    const ReceiveResult received =
        socket_.receive(message, ended ? milliseconds(0) : kPollInterval);
    if (received != ReceiveResult::Timeout) return received;
    if (ended) return ReceiveResult::Closed;
  }
}

Status ProcessHandle::readReply(const SocketMessage& reply, const Read& read) {
  try {
    const std::uint64_t limit_mib = launch_.memory_mib > 0 ? launch_.memory_mib : kMaxReplyMib;
    if (reply.size > limit_mib << 20U) {
      throw MalformedMessage("it is larger than isolation.memory_limit");
    }
    Decoder decoder(response_.view(reply.size), reply.size);
    Status status = decoder.next<Status>();
    if (status.isOk()) read(decoder);
    if (decoder.remaining() > 0) throw MalformedMessage("bytes follow its end");
    const bool out_of_memory = status.message().find("std::bad_alloc") != std::string::npos;
    if (!out_of_memory || launch_.memory_mib == 0) return status;
    return {status.code(), status.message() + fmt::format("; isolation.memory_limit is {} MiB",
                                                          launch_.memory_mib)};
  } catch (const std::exception& error) {
    return end(std::string("sent a malformed reply and was killed: ") + error.what());
  }
}

Status ProcessHandle::readExit() {
  const ProcessEnd ended = process_->end(kExitTimeout);
  if (ended.signal == 0) exit_code_ = ended.exit_code;
  const std::string place = ended.signal == 0 ? "" : stack_.left(launch_.program);
  return end(ended.text() + (place.empty() ? "" : " at " + place));
}

Status ProcessHandle::endAtDeadline() {
  const std::string place = stack_.ask(*process_, launch_.program);
  return end(fmt::format("did not return within {:g} s and was killed{}", launch_.deadline_s,
                         place.empty() ? "" : " at " + place));
}

Status ProcessHandle::end(const std::string& reason) {
  exit_reason_ = reason;
  (void)process_->end(milliseconds(0));
  return Status::failed("its process " + reason);
}

}  // namespace tolman::host
