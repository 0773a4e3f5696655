// SPDX-License-Identifier: BSD-3-Clause
// Parameters of scanline.
#pragma once

#include "tolman/parameters.hpp"

namespace tolman::scanline {

/// Where nothing else is said the default is chosen, not tuned; README.md has measured errors.
struct Parameters {
  double field_of_view = 81.6;  // deg; KITTI's
  double turn_x_min = 0.3;
  double turn_x_max = 0.7;
  double turn_y_min = 0.2;
  double turn_y_max = 0.5;
  double largest_turn = 15;  // deg
  double speed_x_min = 0;
  double speed_x_max = 1;
  double speed_y_min = 0.5;
  double speed_y_max = 1;
  double metres_per_difference = 35;  // m; fitted to three KITTI clips (README.md)
  double still = 0.002;               // grey levels of 0 to 1
  double largest_speed = 30;          // m/s
  double weakest_contrast = 0.01;     // grey levels of 0 to 1
  double sigma_turn = 0.3;            // deg
  double sigma_distance = 0.3;        // of the distance

  static constexpr auto declaration() {
    using P = Parameters;
    return tolman::parameters(
        parameter("field_of_view", &P::field_of_view)
            .range(1, 360)
            .unit("deg")
            .doc("Horizontal field of view of the whole image, for cameras without calibration."),
        parameter("turn_x_min", &P::turn_x_min)
            .range(0, 1)
            .doc("Left edge of the image region used for turns, as a fraction of the width."),
        parameter("turn_x_max", &P::turn_x_max).range(0, 1).doc("Right edge of that region."),
        parameter("turn_y_min", &P::turn_y_min)
            .range(0, 1)
            .doc("Upper edge of that region; it should show distant objects."),
        parameter("turn_y_max", &P::turn_y_max).range(0, 1).doc("Lower edge of that region."),
        parameter("largest_turn", &P::largest_turn)
            .range(0.1, 180)
            .unit("deg")
            .doc("Largest turn between two frames that is searched for."),
        parameter("speed_x_min", &P::speed_x_min)
            .range(0, 1)
            .doc("Left edge of the image region used for speed, as a fraction of the width."),
        parameter("speed_x_max", &P::speed_x_max).range(0, 1).doc("Right edge of that region."),
        parameter("speed_y_min", &P::speed_y_min)
            .range(0, 1)
            .doc("Upper edge of that region; it should show near objects."),
        parameter("speed_y_max", &P::speed_y_max).range(0, 1).doc("Lower edge of that region."),
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
        parameter("weakest_contrast", &P::weakest_contrast)
            .range(0, 1)
            .doc("Smallest standard deviation of a usable profile."),
        parameter("sigma_turn", &P::sigma_turn)
            .range(1e-3, 90)
            .unit("deg")
            .doc("Smallest standard deviation of a turn between two frames."),
        parameter("sigma_distance", &P::sigma_distance)
            .range(0.01, 10)
            .doc("Standard deviation of the distance between two frames, relative to it."));
  }
};

}  // namespace tolman::scanline
