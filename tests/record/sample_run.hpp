// SPDX-License-Identifier: BSD-3-Clause
// Random records, and a small run made by hand, for the tests of the record.
#pragma once

#include "record/recorder.hpp"
#include "tolman/context.hpp"

namespace tolman::test {

inline Eigen::Isometry3d randomPose(RandomStream& random) {
  Vector6d twist;
  for (int i = 0; i < 6; ++i) twist[i] = random.uniform(-1, 1);
  return expSe3(twist);
}

/// Fills any value a record may have with random contents.
template <class T>
void randomise(T& value, RandomStream& random) {
  if constexpr (std::is_same_v<T, bool>) {
    value = random.below(2) == 1;
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(random.bits() >> 34U);
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(random.normal());
  } else if constexpr (NamedEnum<T>) {
    value = static_cast<T>(random.below(enumNames(value).size()));
  } else if constexpr (std::is_same_v<T, std::string>) {
    value = "t\xc3\xa4xt '" + std::to_string(random.bits()) + "\"";
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    value = randomPose(random);
  } else if constexpr (record::kIsMatrix<T>) {
    if constexpr (T::ColsAtCompileTime == Eigen::Dynamic) value.resize(Eigen::NoChange, 5);
    for (auto& entry : value.reshaped()) randomise(entry, random);
  }
}

template <Record R>
R randomRecord(RandomStream& random) {
  R record;
  visitFields(record, [&](const Field&, auto& value) { randomise(value, random); });
  return record;
}

inline Frame frameAt(std::int64_t index) {
  Frame frame;
  frame.frame = frame.source_index = index;
  frame.stamp_ns = 1'000'000'000 + index * 100'000'000;
  return frame;
}

/// One metre forward a frame.
inline Motion motionAt(std::int64_t index) {
  Motion motion;
  motion.frame = index;
  motion.stamp_ns = frameAt(index).stamp_ns;
  if (index == 0) return motion;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current.translation().z() = 1;
  setPlanarVelocity(motion, 0.1);
  return motion;
}

inline Experience experienceAt(std::int64_t id, std::int64_t frame, double z) {
  Experience experience{id, frame, id, Eigen::Isometry3d::Identity()};
  experience.T_world_experience.translation().z() = z;
  return experience;
}

inline Link linkBetween(std::int64_t id, std::int64_t from, std::int64_t to, std::int64_t frame) {
  Link link;
  link.id = id;
  link.from = from;
  link.to = to;
  link.frame = frame;
  link.T_from_to.translation().z() = 2;
  link.covariance.diagonal().setConstant(0.25);
  return link;
}

/// Frames 0 ... frames - 1 straight ahead, all on experience 0.
inline Status recordFrame(record::Recorder& recorder, std::int64_t index) {
  const Frame frame = frameAt(index);
  const Motion motion = motionAt(index);
  const MapGraph graph{0, {experienceAt(0, 0, 0)}, {}, {}};
  MapUpdate update;
  update.frame = index;
  update.stamp_ns = frame.stamp_ns;
  update.experience = 0;
  update.T_experience_camera.translation().z() = static_cast<double>(index);
  const std::vector<NamedArray> cells = {{"hd.activity", {3}, {1, 2, static_cast<float>(index)}}};
  Snapshot snapshot;
  snapshot.frame = &frame;
  snapshot.motion = &motion;
  snapshot.map = &update;
  snapshot.cells = &cells;
  snapshot.graph = index == 0 ? &graph : nullptr;
  return recorder.snapshot(snapshot);
}

}  // namespace tolman::test
