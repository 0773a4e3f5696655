// SPDX-License-Identifier: BSD-3-Clause
// Poses of recent frames and the revisions of their motions.
#include "trajectory.hpp"

#include <algorithm>

namespace tolman::direct_sparse {

Eigen::Isometry3d Trajectory::add(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                                  const Keyframe& keyframe, const Matrix6d& covariance) {
  Entry entry;
  entry.frame = frame;
  entry.keyframe = keyframe.frame;
  entry.T_keyframe_camera = normalised(keyframe.T_camera_world() * T_world_camera);
  entry.T_world_camera = T_world_camera;
  entry.covariance = covariance;
  if (!entries_.empty()) {
    entry.answered = normalised(entries_.back().T_world_camera.inverse() * T_world_camera);
  }
  entries_.push_back(entry);
  if (entries_.size() > kMost) entries_.pop_front();
  return entry.answered;
}

void Trajectory::follow(const Window& window) {
  for (Entry& entry : entries_) {
    const Keyframe* keyframe = window.find(entry.keyframe);
    if (keyframe == nullptr) continue;
    entry.T_world_camera = normalised(keyframe->T_world_camera() * entry.T_keyframe_camera);
  }
}

void Trajectory::bridge(std::int64_t first_lost, const Eigen::Isometry3d& T_world_current) {
  const auto lost = std::find_if(entries_.begin(), entries_.end(),
                                 [first_lost](const Entry& e) { return e.frame >= first_lost; });
  if (lost == entries_.begin() || lost == entries_.end()) return;
  const Eigen::Isometry3d T_world_good = std::prev(lost)->T_world_camera;
  const Vector6d whole = logSe3(T_world_good.inverse() * T_world_current);
  const auto steps = static_cast<double>(std::distance(lost, entries_.end()) + 1);
  double step = 1;
  for (auto entry = lost; entry != entries_.end(); ++entry, ++step) {
    const Eigen::Isometry3d moved = normalised(T_world_good * expSe3(whole * (step / steps)));
    entry->T_keyframe_camera =
        normalised(entry->T_keyframe_camera * entry->T_world_camera.inverse() * moved);
    entry->T_world_camera = moved;
  }
}

std::vector<MotionRevision> Trajectory::collect(double metres, double radians, std::size_t end) {
  std::vector<MotionRevision> revisions;
  for (std::size_t i = 1; i < end; ++i) {
    Entry& entry = entries_[i];
    const Eigen::Isometry3d motion =
        normalised(entries_[i - 1].T_world_camera.inverse() * entry.T_world_camera);
    const Eigen::Isometry3d change = entry.answered.inverse() * motion;
    // Products of poses round; a change below that is none.
    const bool moved = change.translation().norm() > std::max(metres, 1e-9);
    const bool turned = logSo3(change.linear()).norm() > std::max(radians, 1e-9);
    if (!moved && !turned) continue;
    entry.answered = motion;
    revisions.push_back({entry.frame, motion, entry.covariance});
  }
  return revisions;
}

std::vector<MotionRevision> Trajectory::revisions() { return collect(1e-3, 1e-5, entries_.size()); }

std::vector<MotionRevision> Trajectory::retire(const Window& window) {
  std::size_t end = 0;
  while (end < entries_.size() && window.find(entries_[end].keyframe) == nullptr) ++end;
  if (end == 0) return {};
  std::vector<MotionRevision> revisions = collect(0, 0, end);
  entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(end) - 1);
  return revisions;
}

}  // namespace tolman::direct_sparse
