// SPDX-License-Identifier: BSD-3-Clause
// The state of the cells, written to and read from a stream.
#pragma once

#include <iosfwd>

#include "attractor_state.hpp"
#include "tolman/status.hpp"

namespace tolman::bayesian_attractor {

Status saveState(const AttractorState& state, std::ostream& stream);

/// Overwrites `state`, which must be fresh; it is not to be used after a failure.
Status loadState(std::istream& stream, AttractorState& state);

}  // namespace tolman::bayesian_attractor
