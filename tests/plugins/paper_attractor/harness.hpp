// SPDX-License-Identifier: BSD-3-Clause
// A configured paper_attractor plugin, and functions that give it frames.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "paper_attractor.hpp"
#include "support/context.hpp"

namespace tolman::paper_attractor::test {

inline Status configure(PaperAttractor& plugin, const ParameterValues& parameters) {
  tolman::test::TestContext services(parameters);
  return plugin.configure(services);
}

inline Motion motionOf(const PlanarPose& step, std::int64_t frame = 0) {
  Motion motion;
  motion.frame = frame;
  motion.stamp_ns = frame * 100'000'000;
  motion.state = TrackingState::Tracking;
  motion.T_previous_current = fromPlanar(step);
  setPlanarVelocity(motion, 0.1);
  return motion;
}

inline PlaceObservation nothing() { return {}; }

inline PlaceObservation novel(std::int64_t id) {
  PlaceObservation seen;
  seen.recognition = Recognition::Novel;
  seen.template_id = id;
  return seen;
}

inline PlaceObservation familiar(std::int64_t id, double relative_yaw = 0) {
  PlaceObservation seen;
  seen.recognition = Recognition::Familiar;
  seen.template_id = id;
  seen.relative_yaw = relative_yaw;
  return seen;
}

inline Decision step(PaperAttractor& plugin, const Motion& motion, const PlaceObservation& seen) {
  Decision decision;
  const Status status = plugin.step(motion, seen, decision);
  if (!status.isOk()) throw std::runtime_error(status.message());
  return decision;
}

inline std::vector<float> arrayOf(const PaperAttractor& plugin, std::string_view name) {
  std::vector<NamedArray> arrays;
  plugin.arrays(arrays);
  for (const NamedArray& array : arrays) {
    if (array.name == name) return array.values;
  }
  throw std::runtime_error("no array " + std::string(name));
}

}  // namespace tolman::paper_attractor::test
