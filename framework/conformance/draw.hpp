// SPDX-License-Identifier: BSD-3-Clause
// Parameters by chance, all of them legal.
#pragma once

#include <string>

#include "conformance/specimen.hpp"
#include "tolman/context.hpp"

namespace tolman::conformance {

/// Draw number `index` of a seed, the same on every machine. What the command line gave stays.
ParameterValues drawParameters(const Specimen& specimen, std::uint64_t seed, int index);

/// What differs from the specimen's own values: "--set a=1 --set b=false".
std::string difference(const ParameterValues& base, const ParameterValues& drawn);

}  // namespace tolman::conformance
