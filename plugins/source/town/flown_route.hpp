// SPDX-License-Identifier: BSD-3-Clause
// A built-in route as a flight, and the streets below a flight.
#pragma once

#include "route.hpp"

namespace tolman::town {

/// A flight along the same streets, 0 to 4 m above the first camera as a function of the place.
/// Pitch and roll of up to 8 degrees are functions of time, so they differ between passes.
CameraRoute flown(const CameraRoute& driven);

/// The same path on level ground at the height of the first pose, without pitch and roll.
CameraRoute groundTrack(const CameraRoute& flown);

}  // namespace tolman::town
