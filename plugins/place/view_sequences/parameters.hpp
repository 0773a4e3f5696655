// SPDX-License-Identifier: BSD-3-Clause
// Parameters of view_sequences.
#pragma once

#include "tolman/parameters.hpp"

namespace tolman::view_sequences {

/// docs/report/places.md says on what data memory and probabilities were chosen. The others are
/// chosen, not tuned.
struct Parameters {
  double spacing = 1.0;         // m
  double recent = 20;           // m
  double probability = 0.8;     // for images without look-alikes (README.md)
  double memory = 0.92;         // walks, corridor
  int exhaustive = 4000;        // views; bounds the time
  double field_of_view = 81.6;  // deg; KITTI's
  int landmarks = 0;
  int landmark_spacing = 4;
  bool backwards = false;
  double probability_backwards = 0.999;  // town 00: one false place has 0.9989

  static constexpr auto declaration() {
    using P = Parameters;
    return parameters(
        parameter("spacing", &P::spacing)
            .range(0.01, 100)
            .unit("m")
            .doc("Driven distance from one step to the next; frames between two steps are not "
                 "used."),
        parameter("recent", &P::recent)
            .range(0, 10000)
            .unit("m")
            .doc("Length of the newest part of the path, whose views are not recognised."),
        parameter("probability", &P::probability)
            .range(0.01, 0.999999)
            .doc("Smallest probability of a place that is familiar. The score is 1 minus the "
                 "probability of the best place."),
        parameter("memory", &P::memory)
            .range(0, 0.99)
            .doc("Share of a path's cost that a step keeps: with 0 single views count, with 0.92 "
                 "about a dozen."),
        parameter("exhaustive", &P::exhaustive)
            .range(0, 10000000)
            .unit("views")
            .doc("With more views than this, codes of 256 bits choose the ones that are compared."),
        parameter("field_of_view", &P::field_of_view)
            .range(1, 179)
            .unit("deg")
            .doc("Horizontal field of view, for cameras without calibration."),
        parameter("landmarks", &P::landmarks)
            .range(0, 5000)
            .doc("Corners of a stereo pair that views keep to verify places and measure poses, "
                 "on which one in 25, 6 to 20, must agree; 0 turns this off."),
        parameter("landmark_spacing", &P::landmark_spacing)
            .range(1, 1000)
            .unit("steps")
            .doc("Number of steps from one stored view with landmarks to the next, and from one "
                 "measured pose of a familiar place to the next, in either direction."),
        parameter("backwards", &P::backwards)
            .doc("Also recognise streets that are driven in the opposite direction, by the "
                 "structure that a stereo pair measures."),
        parameter("probability_backwards", &P::probability_backwards)
            .range(0.01, 0.999999)
            .doc("Smallest probability of a familiar place that is driven in the opposite "
                 "direction."));
  }
};

}  // namespace tolman::view_sequences
