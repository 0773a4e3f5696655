// SPDX-License-Identifier: BSD-3-Clause
// The newest events, numbered, so that each client gets every event once.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::web_viewer {

class EventLog {
 public:
  void append(const std::vector<RunEvent>& events) {
    events_.insert(events_.end(), events.begin(), events.end());
    end_ += events.size();
    while (events_.size() > kMax) events_.pop_front();
  }
  std::size_t end() const { return end_; }

  /// The newest events from number `next` on, at most `count`.
  std::vector<RunEvent> since(std::size_t next, std::size_t count) const {
    const std::size_t missed = end_ - std::min(next, end_);
    const std::size_t sent = std::min({missed, count, events_.size()});
    return {events_.end() - static_cast<std::ptrdiff_t>(sent), events_.end()};
  }

 private:
  static constexpr std::size_t kMax = 1000;
  std::deque<RunEvent> events_;
  std::size_t end_ = 0;
};

// The newest messages of /api/events, numbered, so that each client gets every one once.

class MessageLog {
 public:
  static constexpr std::size_t kMax = 1000;

  void append(const std::vector<std::string>& messages) {
    for (const std::string& text : messages) {
      messages_.push_back(std::make_shared<const std::string>(text));
    }
    end_ += messages.size();
    while (messages_.size() > kMax) messages_.pop_front();
  }
  std::size_t end() const { return end_; }

  /// Returns the message with the number `next` and increments `next`; null at the end. If that
  /// message was dropped: a message with the number of dropped ones, and `next` is that of the
  /// oldest.
  std::shared_ptr<const std::string> next(std::size_t& next) const {
    const std::size_t oldest = end_ - messages_.size();
    if (next < oldest) {
      const std::size_t missed = oldest - next;
      next = oldest;
      return std::make_shared<const std::string>(R"({"type":"missed","messages":)" +
                                                 std::to_string(missed) + "}");
    }
    return next < end_ ? messages_[next++ - oldest] : nullptr;
  }

 private:
  std::deque<std::shared_ptr<const std::string>> messages_;
  std::size_t end_ = 0;
};

// The newest pose of the robot, for other programs (/api/pose and /api/events).

struct LatestPose {
  std::int64_t frame = -1;  ///< -1: none yet
  std::int64_t stamp_ns = 0;
  TrackingState state = TrackingState::Initialising;
  bool scale_known = true;
  std::int64_t experience = -1;
  Eigen::Isometry3d T_experience_camera = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();

  void assign(const Snapshot& snapshot) {
    if (snapshot.map == nullptr || snapshot.motion == nullptr) return;
    frame = snapshot.frame->frame;
    stamp_ns = snapshot.frame->stamp_ns;
    state = snapshot.motion->state;
    scale_known = snapshot.motion->scale_known;
    experience = snapshot.map->experience;
    T_experience_camera = snapshot.map->T_experience_camera;
    T_world_camera = snapshot.map->T_world_camera;
  }

  /// Places the pose in the final graph, which a map optimises once more after the last frame: as
  /// the page does with all frames, it stays where it was seen from its experience.
  void assignFinal(const MapGraph& graph) {
    const auto found = std::ranges::find(graph.experiences, experience, &Experience::id);
    if (frame < 0 || found == graph.experiences.end()) return;
    T_world_camera = found->T_world_experience * T_experience_camera;
  }
};

}  // namespace tolman::web_viewer
