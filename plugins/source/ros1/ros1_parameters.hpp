// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `ros1`, the same with and without ROS in the build.
#pragma once

#include <string>
#include <tuple>

#include "message_cameras.hpp"
#include "tolman/parameters.hpp"

namespace tolman::ros1 {

struct Ros1Parameters : source_parameters::CameraParameters {
  std::string master;
  double wait = 5;
  bool end_when_silent = false;
  std::int64_t last = -1;
  std::int64_t step = 1;

  static constexpr auto declaration();
};

constexpr auto Ros1Parameters::declaration() {
  using P = Ros1Parameters;
  return std::tuple_cat(
      parameters(parameter("master", &P::master)
                     .doc("URI of the roscore; empty: $ROS_MASTER_URI, or "
                          "http://localhost:11311.")),
      source_parameters::cameraTopics<P>(),
      parameters(
          parameter("wait", &P::wait)
              .range(0.1, 3600)
              .unit("s")
              .doc("Longest time to wait for topics, for the first image, and for each other."),
          parameter("end_when_silent", &P::end_when_silent)
              .doc("The run ends well when no image came for that time, as after a replayed bag; "
                   "otherwise that is a failure."),
          parameter("last", &P::last)
              .range(-1, 1e9)
              .doc("Last image to use, from 0; -1 for as many as come."),
          parameter("step", &P::step).range(1, 1e9).doc("Use every step-th image.")),
      source_parameters::cameraImages<P>(
          "Largest difference between the stamps of a stereo pair."));
}

}  // namespace tolman::ros1
