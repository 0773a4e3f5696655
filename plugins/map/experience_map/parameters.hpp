// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the experience map.
#pragma once

#include <tolman/parameters.hpp>
#include <tuple>

#include "graph_optimiser.hpp"

namespace tolman::experience_map {

/// The geometry in which poses are corrected.
enum class Geometry : std::uint8_t { Auto, Plane, Space };
inline constexpr std::array<std::string_view, 3> kGeometryNames = {"auto", "plane", "space"};
constexpr std::span<const std::string_view> enumNames(Geometry) { return kGeometryNames; }

/// Unless a comment says otherwise, a default is chosen, not tuned.
struct Parameters {
  bool optimise = true;
  Geometry space = Geometry::Auto;
  int interval = 10;
  double interval_growth = 0.02;  // frames; bounds the mean time of a frame
  Loss loss = Loss::GemanMcclure;
  double huber_delta = 1.0;          // the paper names none
  double geman_mcclure_scale = 4.0;  // standard deviations
  double min_loop_weight = 0.1;
  bool huber_odometry = false;
  double drift_translation = 0.01;  // m/m
  double drift_rotation = 0.0005;   // rad/m; see recalibrate
  bool recalibrate = true;
  double assumed_sigma_translation = 3.0;   // m
  double assumed_sigma_rotation = 0.15;     // rad
  double measured_sigma_translation = 0.1;  // m
  double measured_sigma_rotation = 0.01;    // rad

 private:
  static constexpr auto optimiserParameters() {
    using P = Parameters;
    return parameters(
        parameter("optimise", &P::optimise).doc("Correct the map when loops close."),
        parameter("space", &P::space)
            .doc("plane: position and heading are corrected in the plane of the first camera, "
                 "height, pitch and roll remain those of odometry. space: all six. auto: space as "
                 "soon as a "
                 "loop with a measured pose is closed, unless all motions lie in the plane or "
                 "their scale is not known."),
        parameter("interval", &P::interval)
            .range(1, 1e6)
            .unit("frames")
            .doc("Minimal interval between two corrections while running."),
        parameter("interval_growth", &P::interval_growth)
            .range(0, 100)
            .unit("frames")
            .doc("Growth of the interval per node, so that the mean time per frame stays bounded."),
        parameter("loss", &P::loss).doc("Robust loss of loop links; huber as in the paper."),
        parameter("huber_delta", &P::huber_delta)
            .range(1e-6, 1e9)
            .doc("Huber: residual, in standard deviations, above which the loss is linear."),
        parameter("geman_mcclure_scale", &P::geman_mcclure_scale)
            .range(1e-3, 1e9)
            .doc("Geman-McClure: residual, in standard deviations, at which the weight is a "
                 "quarter."),
        parameter("min_loop_weight", &P::min_loop_weight)
            .range(0, 1)
            .doc("Loop links whose weight is below this after the last frame are rejected."),
        parameter("huber_odometry", &P::huber_odometry)
            .doc("Whether Huber's loss applies to odometry links too, as in the paper."));
  }

  static constexpr auto trustParameters() {
    using P = Parameters;
    return parameters(
        parameter("drift_translation", &P::drift_translation)
            .range(1e-9, 1)
            .doc("Standard deviation of translation, m per m travelled, added to the "
                 "covariance of an odometry link."),
        parameter("drift_rotation", &P::drift_rotation)
            .range(1e-9, 1)
            .unit("rad/m")
            .doc("The same for its rotation."),
        parameter("recalibrate", &P::recalibrate)
            .doc("Learn from closed loops the steady errors of odometry (gains of distances and "
                 "turns, turn per second and per metre, in space also drift to the side and in "
                 "height) and its noise."),
        parameter("assumed_sigma_translation", &P::assumed_sigma_translation)
            .range(1e-6, 1e6)
            .unit("m")
            .doc("Standard deviation of the offset from the experience when a loop "
                 "has no measured pose. A frame without measured motion adds a third of it."),
        parameter("assumed_sigma_rotation", &P::assumed_sigma_rotation)
            .range(1e-6, 10)
            .unit("rad")
            .doc("The same for its heading."),
        parameter("measured_sigma_translation", &P::measured_sigma_translation)
            .range(1e-9, 1e6)
            .unit("m")
            .doc("Standard deviation added to the measured pose of a loop."),
        parameter("measured_sigma_rotation", &P::measured_sigma_rotation)
            .range(1e-9, 10)
            .unit("rad")
            .doc("The same for its rotation."));
  }

 public:
  static constexpr auto declaration() {
    return std::tuple_cat(optimiserParameters(), trustParameters());
  }
};

}  // namespace tolman::experience_map
