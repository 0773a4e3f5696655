// SPDX-License-Identifier: BSD-3-Clause
#include "isolation/worker.hpp"

#include <fmt/format.h>

#include <new>

namespace tolman::isolation {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kSlice{20};  // how late a cancellation may be passed on
constexpr std::uint64_t kMostReplyMib = 1U << 16U;
constexpr milliseconds kFarewell{500};  // for a process that closed its end: it is on its way out

}  // namespace

Worker::Worker(Launch launch)
    : launch_(std::move(launch)),
      request_("tolman-request"),
      response_("tolman-response"),
      control_memory_("tolman-control"),
      control_(new (control_memory_.reserve(sizeof(ControlBlock))) ControlBlock{}),
      socket_(Descriptor()) {
  auto [ours, theirs] = Socket::pair();
  const std::vector<int> passed = {theirs.descriptor(), request_.descriptor(),
                                   response_.descriptor(), control_memory_.descriptor()};
  std::vector<std::string> command = launch_.command;
  for (const int descriptor : passed) command.push_back(std::to_string(descriptor));
  process_ = std::make_unique<ChildProcess>(command, passed);
  socket_ = std::move(ours);
}

void Worker::serve(Logger* log, const Cancellation* cancellation) {
  log_ = log;
  cancellation_ = cancellation;
}

Status Worker::ask(Call call, const Write& write, const Read& read) {
  Encoder encoder(request_);
  write(encoder);
  request_size_ = encoder.size();
  Note note;
  note.kind = static_cast<std::uint32_t>(call);
  note.detail = ++serial_;
  note.size = request_size_;
  if (keep_requests_) {  // now: what is shared may be overwritten
    kept_request_.assign(reinterpret_cast<const char*>(request_.view(request_size_)),
                         request_size_);
  }
  if (!socket_.send(note)) return died();
  const auto begin = steady_clock::now();
  for (;;) {
    const Wait heard = listen(note, begin);
    if (heard == Wait::Gone) return died();
    if (heard == Wait::Nothing) {
      return ended(
          fmt::format("did not return within {:g} s; its process was ended", launch_.deadline_s));
    }
    if (note.kind == static_cast<std::uint32_t>(Word::Reply)) {
      if (note.detail == serial_) return take(note, read);
      continue;  // of a copy of the process that the plugin made
    }
    if (log_ != nullptr && note.detail <= static_cast<std::uint32_t>(LogLevel::Error)) {
      log_->write(static_cast<LogLevel>(note.detail), note.text);
    }
  }
}

/// Until there is a note, or the deadline (Nothing).
Wait Worker::listen(Note& note, steady_clock::time_point begin) {
  for (;;) {
    const std::chrono::duration<double> waited = steady_clock::now() - begin;
    if (launch_.deadline_s > 0 && waited.count() > launch_.deadline_s) return Wait::Nothing;
    const bool cancelled = cancellation_ != nullptr && cancellation_->requested();
    control_->cancelled.store(cancelled ? 1 : 0, std::memory_order_relaxed);
    // What the plugin has started may hold the socket open: ask for the process itself, too. Before
    // the socket, for its last words may be in there.
    const bool ended = process_->hasEnded();
    const Wait heard = socket_.receive(note, ended ? milliseconds(0) : kSlice);
    if (heard != Wait::Nothing) return heard;
    if (ended) return Wait::Gone;
  }
}

Status Worker::take(const Note& reply, const Read& read) {
  try {
    const std::uint64_t most = launch_.memory_mib > 0 ? launch_.memory_mib : kMostReplyMib;
    if (reply.size > most << 20U) throw Malformed("a message larger than isolation.memory_limit");
    Decoder decoder(response_.view(reply.size), reply.size);
    Status status = decoder.next<Status>();
    if (status.isOk()) read(decoder);
    if (decoder.remaining() > 0) throw Malformed("a message with something behind its end");
    const bool starved = status.message().find("std::bad_alloc") != std::string::npos;
    if (!starved || launch_.memory_mib == 0) return status;
    return {status.code(), status.message() + fmt::format("; isolation.memory_limit is {} MiB",
                                                          launch_.memory_mib)};
  } catch (const std::exception& error) {
    return ended(std::string("its process answered nonsense and was ended: ") + error.what());
  }
}

Status Worker::died() {
  gone_ = true;
  return Status::failed("its process " + process_->end(kFarewell).text());
}

Status Worker::ended(const std::string& why) {
  gone_ = true;
  (void)process_->end(milliseconds(0));
  return Status::failed(why);
}

void Worker::abandon() {
  gone_ = true;
  (void)process_->end(milliseconds(0));
}

}  // namespace tolman::isolation
