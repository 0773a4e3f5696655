// SPDX-License-Identifier: BSD-3-Clause
// All that decides the future of the cells, written to and read from a stream.
#pragma once

#include <iosfwd>

#include "attractor_state.hpp"
#include "parameters.hpp"
#include "tolman/status.hpp"

namespace tolman::bayesian_attractor {

Status saveState(const AttractorParameters& parameters, const AttractorState& state,
                 std::ostream& stream);

/// Overwrites the state, which holds rubbish after a failure.
Status loadState(const AttractorParameters& parameters, std::istream& stream,
                 AttractorState& state);

}  // namespace tolman::bayesian_attractor
