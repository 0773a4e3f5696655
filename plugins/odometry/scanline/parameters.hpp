// SPDX-License-Identifier: BSD-3-Clause
// Parameters of scanline.
#pragma once

#include <vector>

#include "tolman/parameters.hpp"

namespace tolman::scanline {

/// Where nothing else is said the default is chosen, not tuned; README.md has measured errors.
struct Parameters {
  double field_of_view = 81.6;  // deg; KITTI's
  std::vector<double> turn_region = {0.3, 0.7, 0.2, 0.5};
  double largest_turn = 15;  // deg
  std::vector<double> speed_region = {0, 1, 0.5, 1};
  double metres_per_difference = 35;  // m; fitted to three KITTI clips (README.md)
  double still = 0.002;               // grey levels of 0 to 1
  double largest_speed = 30;          // m/s
  double sigma_distance = 0.3;        // of the distance

  static constexpr auto declaration() {
    using P = Parameters;
    return tolman::parameters(
        parameter("field_of_view", &P::field_of_view)
            .range(1, 360)
            .unit("deg")
            .doc("Horizontal field of view of the whole image, for cameras without calibration."),
        parameter("turn_region", &P::turn_region)
            .range(0, 1)
            .doc(
                "[left, right, upper, lower] edge of the image region used for turns, as fractions "
                "of width and height; it should show distant objects."),
        parameter("largest_turn", &P::largest_turn)
            .range(0.1, 180)
            .unit("deg")
            .doc("Largest turn between two frames that is searched for."),
        parameter("speed_region", &P::speed_region)
            .range(0, 1)
            .doc("The same for speed; it should show near objects."),
        parameter("metres_per_difference", &P::metres_per_difference)
            .range(1e-6, 1e6)
            .unit("m")
            .doc("Distance for a mean difference of 1 between two profiles; sets the scale."),
        parameter("still", &P::still)
            .range(0, 1)
            .doc("Mean difference caused by noise; below it the camera stands."),
        parameter("largest_speed", &P::largest_speed)
            .range(1e-3, 1e4)
            .unit("m/s")
            .doc("Largest plausible speed; larger values are limited to it."),
        parameter("sigma_distance", &P::sigma_distance)
            .range(0.01, 10)
            .doc("Standard deviation of the distance between two frames, relative to it."));
  }
};

}  // namespace tolman::scanline
