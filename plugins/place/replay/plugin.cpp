// SPDX-License-Identifier: BSD-3-Clause
// Registration of the replayed place recognition.
#include "tolman/plugin.hpp"

#include "place_replay.hpp"

TOLMAN_PLUGIN(place_replay, tolman::place_replay::PlaceReplay, "0.1.0",
              "Recorded loop candidates as views of templates.");
