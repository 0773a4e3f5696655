// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_thread.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <utility>

namespace tolman::web_viewer {

namespace {

constexpr std::size_t kMaxEvents = 100;
constexpr std::size_t kMaxMessages = 1000;
constexpr std::size_t kMaxImages = 16;  // images of full size
constexpr std::size_t kWakeAtImages = 8;
constexpr std::size_t kMaxValues = 1U << 21U;     // of rows: 16 MiB, about 50,000 rows
constexpr std::size_t kWakeAtValues = 1U << 15U;  // of rows: 256 KiB

}  // namespace

bool Handover::put(const Snapshot& snapshot) {
  std::unique_lock lock(mutex_);
  taken_.wait(lock, [&] {
    const bool room = rows_.size() < kMaxValues && !(every_frame_ && fresh_frame_);
    return closed_ || room;
  });
  if (closed_) return false;
  row_maker_.append(snapshot, rows_);
  newest_.assign(snapshot);
  fresh_frame_ = true;
  if (snapshot.events != nullptr) putEvents(*snapshot.events);
  putTemplateImage(snapshot);
  putMessages(snapshot);
  if (snapshot.graph != nullptr) {
    graph_.assign(*snapshot.graph, snapshot.frame->frame);
    fresh_graph_ = true;
  }
  return every_frame_ || wakes_always_ || rows_.size() >= kWakeAtValues ||
         template_images_.size() >= kWakeAtImages;
}

void Handover::putEvents(const std::vector<RunEvent>& events) {
  const std::size_t taken = std::min(events.size(), kMaxEvents);
  events_.insert(events_.end(), events.end() - static_cast<std::ptrdiff_t>(taken), events.end());
  if (events_.size() <= kMaxEvents) return;
  events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(kMaxEvents));
}

void Handover::putTemplateImage(const Snapshot& snapshot) {
  if (snapshot.place == nullptr || snapshot.place->recognition != Recognition::Novel) return;
  if (snapshot.frame->left.empty() || template_images_.size() >= kMaxImages) return;
  template_images_.push_back({snapshot.place->template_id, snapshot.frame->left});
}

/// If the viewer does not take them in time, the oldest are dropped.
void Handover::putMessages(const Snapshot& snapshot) {
  pose_.assign(snapshot);
  appendMessages(snapshot, messages_);
  if (messages_.size() <= kMaxMessages) return;
  messages_.erase(messages_.begin(), messages_.end() - static_cast<std::ptrdiff_t>(kMaxMessages));
}

void Handover::putGraph(const MapGraph& graph) {
  const std::lock_guard lock(mutex_);
  graph_.assign(graph, -1);
  pose_.assignFinal(graph);
  fresh_graph_ = true;
}

void Handover::take(PendingData& pending, bool frame, bool graph) {
  pending.rows.clear();
  pending.events.clear();
  pending.messages.clear();
  pending.template_images.clear();
  {
    const std::lock_guard lock(mutex_);
    std::swap(pending.rows, rows_);
    std::swap(pending.events, events_);
    std::swap(pending.messages, messages_);
    pending.pose = pose_;
    std::swap(pending.template_images, template_images_);
    pending.has_frame = frame && std::exchange(fresh_frame_, false);
    pending.has_graph = graph && std::exchange(fresh_graph_, false);
    if (pending.has_frame) std::swap(pending.newest, newest_);
    if (pending.has_graph) std::swap(pending.graph, graph_);
  }
  taken_.notify_all();
}

void Handover::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  taken_.notify_all();
}

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
