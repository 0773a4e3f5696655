// SPDX-License-Identifier: BSD-3-Clause
#include "handover.hpp"

#include <algorithm>
#include <utility>

namespace tolman::web_viewer {
namespace {

constexpr std::size_t kMaxEvents = 100;
constexpr std::size_t kMaxMessages = 1000;
constexpr std::size_t kMaxImages = 16;  // images of full size
constexpr std::size_t kWakeAtImages = 8;
constexpr std::size_t kMaxValues = 1U << 21U;     // of rows: 16 MiB, about 30,000 rows
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

}  // namespace tolman::web_viewer
