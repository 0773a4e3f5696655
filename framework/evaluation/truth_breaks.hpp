// SPDX-License-Identifier: BSD-3-Clause
// Detects moments from which on true and estimated poses do not belong together any more.
#pragma once

#include <string>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A warning if the truth, over ten steps or more, moves by less than a tenth of the estimate,
/// which moves by 0.5 m (1 % of the true path where that is less) and at over a quarter of the
/// usual speed; else empty. The same with the two exchanged, over a hundred steps. heldHint() finds
/// poses that are exactly alike; these may have noise. The estimate is aligned.
std::string standingHint(const Matches& aligned);

/// A warning if the truth turns in a single step by 3 degrees more than the estimate, and four
/// times as much as in the steps around it, as usual (rms), and as the estimate; else empty.
std::string turnJumpHint(const Matches& matches);

/// A warning if the truth, over thirty steps or more, has exactly one value of a coordinate along
/// which the estimate moves, by half of its largest extent there or more, and by a tenth of that of
/// the whole truth; else empty. A path that is given on a plane has one, but the estimate hardly
/// moves along it. The estimate is aligned.
std::string constantCoordinateHint(const Matches& aligned);

/// A warning if the ratio of estimated to true lengths is by a factor of 1.5 or more another from
/// some frame on, and steady before and after it; else empty. Drift of scale is gradual.
std::string lengthChangeHint(const Matches& aligned);

}  // namespace tolman::evaluation
