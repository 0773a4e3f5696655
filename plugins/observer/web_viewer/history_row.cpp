// SPDX-License-Identifier: BSD-3-Clause
#include "history_row.hpp"

#include <limits>

namespace tolman::web_viewer {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kSecondsPerNs = 1e-9;
constexpr double kMsPerNs = 1e-6;
constexpr std::size_t kShownStages = 5;  // all but the observers

/// Fills a row from left to right, a group at a time; the missing groups stay unknown.
class RowWriter {
 public:
  explicit RowWriter(HistoryRow& row) : row_(row) { row_.fill(kUnknown); }
  template <class... Numbers>
  void put(Numbers... numbers) {
    ((row_.at(next_++) = static_cast<double>(numbers)), ...);
  }
  void put(const Eigen::Vector3d& p) { put(p.x(), p.y(), p.z()); }
  void skip(std::size_t columns) { next_ += columns; }

 private:
  HistoryRow& row_;
  std::size_t next_ = 0;
};

void putMotion(RowWriter& row, const Motion* motion, const Eigen::Isometry3d& T_world_camera) {
  if (motion == nullptr) return row.skip(8);
  row.put(motion->state, motion->v, motion->omega, motion->tracked, motion->is_keyframe);
  row.put(Eigen::Vector3d(T_world_camera.translation()));
}

void putPlace(RowWriter& row, const PlaceObservation* place) {
  if (place == nullptr) return row.skip(3);
  const bool seen = place->recognition != Recognition::None;
  row.put(place->recognition, place->template_id, seen ? place->score : kUnknown);
}

void putDecision(RowWriter& row, const Decision* decision) {
  if (decision == nullptr) return row.skip(4);
  row.put(decision->action, decision->experience, decision->heading, decision->confidence);
}

void putCounts(RowWriter& row, const MapUpdate* map) {
  if (map == nullptr) return row.skip(4);
  row.put(map->experiences, map->links, map->loops, map->version);
}

}  // namespace

const std::array<RowColumn, kColumns> kRowColumns = {{
    {"frame", ""},         {"stamp_s", "s"},    {"tracking", ""},    {"v", "m/s"},
    {"omega", "rad/s"},    {"tracked", ""},     {"keyframe", ""},    {"odo_x", "m"},
    {"odo_y", "m"},        {"odo_z", "m"},      {"map_x", "m"},      {"map_y", "m"},
    {"map_z", "m"},        {"truth_x", "m"},    {"truth_y", "m"},    {"truth_z", "m"},
    {"recognition", ""},   {"template_id", ""}, {"score", ""},       {"action", ""},
    {"experience", ""},    {"heading", "rad"},  {"confidence", ""},  {"experiences", ""},
    {"links", ""},         {"loops", ""},       {"map_version", ""}, {"source_ms", "ms"},
    {"odometry_ms", "ms"}, {"place_ms", "ms"},  {"cells_ms", "ms"},  {"map_ms", "ms"},
}};

HistoryRow RowMaker::next(const Snapshot& snapshot) {
  const Frame& frame = *snapshot.frame;
  if (snapshot.motion != nullptr && begun_) {
    T_world_camera_ = normalised(T_world_camera_ * snapshot.motion->T_previous_current);
  }
  begun_ = begun_ || snapshot.motion != nullptr;
  HistoryRow values;
  RowWriter row(values);
  row.put(frame.frame, static_cast<double>(frame.stamp_ns) * kSecondsPerNs);
  putMotion(row, snapshot.motion, T_world_camera_);
  if (snapshot.map != nullptr) {
    row.put(Eigen::Vector3d(snapshot.map->T_world_camera.translation()));
  } else {
    row.skip(3);
  }
  if (frame.has_truth) {
    if (!T_world_truth_) T_world_truth_ = T_world_camera_ * frame.T_world_camera_truth.inverse();
    row.put(Eigen::Vector3d((*T_world_truth_ * frame.T_world_camera_truth).translation()));
  } else {
    row.skip(3);
  }
  putPlace(row, snapshot.place);
  putDecision(row, snapshot.decision);
  putCounts(row, snapshot.map);
  for (std::size_t stage = 0; stage < kShownStages; ++stage) {
    const std::int64_t ns = snapshot.stage_times_ns[stage];
    row.put(ns > 0 ? static_cast<double>(ns) * kMsPerNs : kUnknown);
  }
  return values;
}

}  // namespace tolman::web_viewer
