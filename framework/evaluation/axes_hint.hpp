// SPDX-License-Identifier: BSD-3-Clause
// Detects poses in another convention than the expected one: truth in other axes than those of the
// estimate (poses of the vehicle's body instead of the camera, world-to-camera poses), quaternions
// in another order, mirrored paths, positions in another unit than metres. An alignment transforms
// the world of the estimate, not its camera axes, so position errors alone do not show wrong
// rotations.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the directions of motion, each in its camera's own axes, differ by more than 45
/// degrees in the mean and one rotation, or inverting the true poses, brings them within 15
/// degrees; else empty. Where the truth drives backwards, it also names a reverse order.
std::string axesHint(const Matches& matches);

/// A warning if the turns of the truth are opposite to those of the estimate, as with an axis or
/// angles of the wrong sign: their correlation, over ten turns or more of 5 degrees and more, is
/// below -0.8; else empty.
std::string turnHint(const Matches& matches);

/// A warning if the aligned positions agree within a twentieth of the true path, but the directions
/// of motion, each in its camera's own axes, differ by more than 45 degrees in the mean, or the
/// aligned orientations by more than 90 degrees in the median, as for mirrored positions; else
/// empty. Of the latter no warning is given where the positions also agree, within a hundredth of
/// the true path or three times the error of the alignment, after the rotation that aligns the
/// orientations: that path is nearly straight, so the positions hardly determine the rotation about
/// it.
std::string rotationHint(const Matches& aligned);

/// A sentence if the poses move along their own x axis and more along the y than along the z axis
/// of the first pose, as poses with x forward and z up do: y is read as down, by se2 and by the
/// division into horizontal and vertical errors. Else empty.
std::string upHint(const Trajectory& truth);

/// A warning if one of the paths is over 50 times as long as the other, if the estimate is shorter
/// than two thirds of a true path of 1 m or more, or does not move, unless the aligned positions
/// agree within a fiftieth of the shorter path; else empty.
std::string unitHint(const Matches& matches);

/// A warning if the median speed of the truth by the stamps, of the estimate where the truth has
/// none, is above 1 km/s, as where both paths are in millimetres; else empty.
std::string speedHint(const Matches& matches);

/// A warning if the estimate agrees with the truth but for its scale, by a factor of more than 1.5
/// and within 2 % of the true path, as with a wrong baseline; else empty. An estimate that is only
/// poor agrees at no scale.
std::string scaleHint(const Matches& matches);

}  // namespace tolman::evaluation
