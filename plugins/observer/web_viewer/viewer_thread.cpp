// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_thread.hpp"

#include <boost/asio/post.hpp>
#include <utility>

namespace tolman::web_viewer {
namespace {

namespace asio = boost::asio;
using namespace std::chrono_literals;

constexpr auto kGraphPeriod = 250ms;
constexpr auto kEndingPeriod = 5ms;
constexpr auto kSendTimeout = 500ms;  // for clients to receive the last messages
constexpr int kMaxFailures = 5;       // in the log

}  // namespace

ViewerThread::ViewerThread(const ViewerOptions& options, Logger& log)
    : options_(options),
      log_(log),
      handover_(options.rate <= 0),
      state_(std::make_shared<ServerState>(options.jpeg_options, options.spool_bytes,
                                           options.clients)),
      timer_(io_),
      server_(io_, state_),
      frame_period_(options.rate > 0 ? std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double>(1 / options.rate))
                                     : Clock::duration(0)) {
  state_->refresh = [this] { take(false); };
}

ViewerThread::~ViewerThread() {
  handover_.close();
  io_.stop();
  if (thread_.joinable()) thread_.join();
}

Status ViewerThread::start() {
  Status status = server_.open(options_.address);
  if (!status.isOk()) return status;
  server_.accept();
  tick();
  thread_ = std::thread([this] { work(); });
  return status;
}

/// Runs the event loop. An exception of one connection or frame is logged and does not end it.
void ViewerThread::work() {
  for (;;) {
    try {
      io_.run();
      return;
    } catch (const std::exception& error) {
      if (failures_++ < kMaxFailures) log_.warning(std::string("viewer: ") + error.what());
    }
  }
}

void ViewerThread::tick() {
  const Clock::duration longest = ending_ ? kEndingPeriod : kGraphPeriod;
  timer_.expires_after(frame_period_ > 0s ? std::min(frame_period_, longest) : longest);
  timer_.async_wait([this](const boost::system::error_code& error) {
    if (error) return;
    tick();
    take(false);
    if (ending_) no_clients_ = server_.dropStalledClients();
  });
}

void ViewerThread::take(bool everything) {
  woken_ = false;
  const Clock::time_point now = Clock::now();
  // Timers fire late rather than early; half a millisecond of tolerance keeps the mean rate.
  const bool frame = everything || now + 500us >= next_frame_;
  const bool graph = everything || now >= next_graph_;
  handover_.take(pending_, frame, graph);
  if (pending_.has_frame) next_frame_ = now + frame_period_;
  if (pending_.has_graph) next_graph_ = now + kGraphPeriod;
  state_->store.add(pending_);
  if (pending_.has_graph) server_.publishGraph();
  if (pending_.has_frame) server_.publishFrame();
  server_.publishNumbers();
  handover_.wakeAlways(state_->event_clients > 0);
}

void ViewerThread::begin(const RunInfo& run) {
  asio::post(io_, [this, run] { state_->store.begin(run, options_.recorded); });
}

void ViewerThread::observe(const Snapshot& snapshot) {
  if (!handover_.put(snapshot) || woken_.exchange(true)) return;
  asio::post(io_, [this] { take(false); });
}

void ViewerThread::end(const char* state, bool keeps_open) {
  take(true);
  state_->keeps_open = keeps_open;
  state_->store.end(state);
  server_.publishEnd();
  if (keeps_open) return;
  server_.close();
  ending_ = true;
  timer_.cancel();
  tick();
}

void ViewerThread::finish(const MapGraph* graph, const char* state,
                          const std::function<bool()>& stays) {
  if (graph != nullptr) handover_.putGraph(*graph);
  if (stays && stays()) {
    asio::post(io_, [this, state] { end(state, true); });
    while (stays()) std::this_thread::sleep_for(50ms);
  }
  asio::post(io_, [this, state] { end(state, false); });
  const Clock::time_point patience = Clock::now() + kSendTimeout;
  while (!no_clients_ && Clock::now() < patience) std::this_thread::sleep_for(2ms);
}

}  // namespace tolman::web_viewer
