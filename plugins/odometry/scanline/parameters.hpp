// SPDX-License-Identifier: BSD-3-Clause
// What a user can set about scanline.
#pragma once

#include "tolman/parameters.hpp"

namespace tolman::scanline {

struct Parameters {
  double field_of_view = 81.6;
  double turn_x_min = 0.3;
  double turn_x_max = 0.7;
  double turn_y_min = 0.2;
  double turn_y_max = 0.5;
  double largest_turn = 15;
  double speed_x_min = 0;
  double speed_x_max = 1;
  double speed_y_min = 0.5;
  double speed_y_max = 1;
  double metres_per_difference = 35;
  double still = 0.002;
  double largest_speed = 30;
  double weakest_contrast = 0.01;
  double sigma_turn = 0.3;
  double sigma_distance = 0.3;

  static constexpr auto declaration() {
    using P = Parameters;
    return tolman::parameters(
        parameter("field_of_view", &P::field_of_view)
            .range(1, 360)
            .unit("deg")
            .doc("Horizontal field of view of the whole image, for cameras without calibration."),
        parameter("turn_x_min", &P::turn_x_min)
            .range(0, 1)
            .doc("Left edge of the part of the image that shows turns, as a fraction."),
        parameter("turn_x_max", &P::turn_x_max).range(0, 1).doc("Its right edge."),
        parameter("turn_y_min", &P::turn_y_min)
            .range(0, 1)
            .doc("Its upper edge; the part should show what is far away."),
        parameter("turn_y_max", &P::turn_y_max).range(0, 1).doc("Its lower edge."),
        parameter("largest_turn", &P::largest_turn)
            .range(0.1, 180)
            .unit("deg")
            .doc("Largest turn between two frames that is looked for."),
        parameter("speed_x_min", &P::speed_x_min)
            .range(0, 1)
            .doc("Left edge of the part of the image that shows speed, as a fraction."),
        parameter("speed_x_max", &P::speed_x_max).range(0, 1).doc("Its right edge."),
        parameter("speed_y_min", &P::speed_y_min)
            .range(0, 1)
            .doc("Its upper edge; the part should show what is near."),
        parameter("speed_y_max", &P::speed_y_max).range(0, 1).doc("Its lower edge."),
        parameter("metres_per_difference", &P::metres_per_difference)
            .range(1e-6, 1e6)
            .unit("m")
            .doc("Way for a mean difference of 1 between two profiles: the scale of everything."),
        parameter("still", &P::still)
            .range(0, 1)
            .doc("Mean difference that noise makes; up to it the camera stands."),
        parameter("largest_speed", &P::largest_speed)
            .range(1e-3, 1e4)
            .unit("m/s")
            .doc("Faster is taken for a sudden change of the scene, and cut off."),
        parameter("weakest_contrast", &P::weakest_contrast)
            .range(0, 1)
            .doc("Standard deviation of a profile below which it shows nothing."),
        parameter("sigma_turn", &P::sigma_turn)
            .range(1e-3, 90)
            .unit("deg")
            .doc("Standard deviation of a turn between two frames, at the least."),
        parameter("sigma_distance", &P::sigma_distance)
            .range(0.01, 10)
            .doc("Standard deviation of the way between two frames, as a part of it."));
  }
};

}  // namespace tolman::scanline
