// SPDX-License-Identifier: BSD-3-Clause
#include "handover.hpp"

#include <algorithm>
#include <utility>

namespace tolman::web_viewer {
namespace {

constexpr std::size_t kMostEvents = 100;
constexpr std::size_t kMostViews = 16;  // each holds an image of full size
constexpr std::size_t kMostRows = 65536;
constexpr std::size_t kWakeAtViews = 8;
constexpr std::size_t kWakeAtRows = 1024;

}  // namespace

bool Handover::put(const Snapshot& snapshot) {
  const HistoryRow row = rows_.next(snapshot);
  std::unique_lock lock(mutex_);
  taken_.wait(lock, [&] {
    const bool room = waiting_rows_.size() < kMostRows && !(every_frame_ && fresh_frame_);
    return closed_ || room;
  });
  if (closed_) return false;
  waiting_rows_.push_back(row);
  newest_.take(snapshot);
  fresh_frame_ = true;
  if (snapshot.events != nullptr) putEvents(*snapshot.events);
  putView(snapshot);
  if (snapshot.graph != nullptr) {
    graph_.take(*snapshot.graph, snapshot.frame->frame);
    fresh_graph_ = true;
  }
  return every_frame_ || waiting_rows_.size() >= kWakeAtRows || views_.size() >= kWakeAtViews;
}

void Handover::putEvents(const std::vector<RunEvent>& events) {
  const std::size_t taken = std::min(events.size(), kMostEvents);
  events_.insert(events_.end(), events.end() - static_cast<std::ptrdiff_t>(taken), events.end());
  if (events_.size() <= kMostEvents) return;
  events_.erase(events_.begin(), events_.end() - static_cast<std::ptrdiff_t>(kMostEvents));
}

void Handover::putView(const Snapshot& snapshot) {
  if (snapshot.place == nullptr || snapshot.place->recognition != Recognition::Novel) return;
  if (snapshot.frame->left.empty() || views_.size() >= kMostViews) return;
  views_.push_back({snapshot.place->template_id, snapshot.frame->left});
}

void Handover::putGraph(const MapGraph& graph) {
  const std::lock_guard lock(mutex_);
  graph_.take(graph, -1);
  fresh_graph_ = true;
}

void Handover::take(Delivery& delivery, bool frame, bool graph) {
  delivery.rows.clear();
  delivery.events.clear();
  delivery.views.clear();
  {
    const std::lock_guard lock(mutex_);
    std::swap(delivery.rows, waiting_rows_);
    std::swap(delivery.events, events_);
    std::swap(delivery.views, views_);
    delivery.has_frame = frame && std::exchange(fresh_frame_, false);
    delivery.has_graph = graph && std::exchange(fresh_graph_, false);
    if (delivery.has_frame) std::swap(delivery.newest, newest_);
    if (delivery.has_graph) std::swap(delivery.graph, graph_);
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

}  // namespace tolman::web_viewer
