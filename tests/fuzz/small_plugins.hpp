// SPDX-License-Identifier: BSD-3-Clause
// Plugins with small states, which the fuzz targets load and make_corpus saves, and frames for
// them.
#pragma once

#include <stdexcept>

#include "support/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::fuzz {

template <class P>
struct Small {
  explicit Small(ParameterValues values, const CameraRig& rig = {}) : context(std::move(values)) {
    context.rig = rig;
    const Status status = plugin.configure(context);
    if (!status.isOk()) throw std::runtime_error(status.message());
  }
  test::TestContext context;
  P plugin;
};

inline ParameterValues smallTemplates() {
  return {{"columns", std::int64_t{8}},
          {"rows", std::int64_t{3}},
          {"shift", std::int64_t{1}},
          {"threshold", 0.03},
          {"landmarks", std::int64_t{20}}};
}

inline ParameterValues smallSequences() {
  return {{"recent", 2.0}, {"landmarks", std::int64_t{10}}, {"probability", 0.3}};
}

inline ParameterValues smallSeqSlam() {
  return {{"columns", std::int64_t{16}},   {"rows", std::int64_t{8}},
          {"sequence", std::int64_t{3}},   {"recent", std::int64_t{2}},
          {"same_place", std::int64_t{1}}, {"quotient", 0.9}};
}

inline ParameterValues smallReplay() {
  return {{"relative_pose", true},
          {"kept", 0.7},
          {"invented", 0.5},
          {"invented_run", std::int64_t{20}}};
}

/// One metre straight on.
inline Motion straightMotion(std::int64_t frame) {
  Motion motion;
  motion.frame = frame;
  motion.stamp_ns = frame % 1000 * 100'000'000;
  motion.state = frame == 0 ? TrackingState::Initialising : TrackingState::Tracking;
  if (frame > 0) motion.T_previous_current.translation().z() = 1;
  motion.covariance.diagonal().setConstant(1e-4);
  setPlanarVelocity(motion, 0.1);
  return motion;
}

inline PlaceObservation seenView(std::int64_t frame, Recognition recognition, std::int64_t id) {
  PlaceObservation view;
  view.frame = frame;
  view.stamp_ns = frame * 100'000'000;
  view.recognition = recognition;
  view.template_id = id;
  return view;
}

/// A frame of a motion log, with one candidate for its place.
inline Frame loggedFrame(std::int64_t index) {
  Frame frame;
  frame.frame = frame.source_index = index;
  frame.stamp_ns = index * 100'000'000;
  frame.sensors.push_back({"place.candidate", {1, 4}, {2, 1, 0, 0}});
  frame.sensors.push_back({"place.looked", {1}, {index % 3 == 0 ? 1.0F : 0.0F}});
  frame.sensors.push_back({"motion.drive", {1}, {7}});
  return frame;
}

}  // namespace tolman::fuzz
