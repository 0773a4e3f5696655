// SPDX-License-Identifier: BSD-3-Clause
// Random legal parameter values: about half of the parameters change, some to an end of their
// range; ranges over two decades are sampled logarithmically.
#pragma once

#include <string>

#include "conformance/test_instance.hpp"
#include "tolman/context.hpp"

namespace tolman::conformance {

/// Draw number `index` of a seed, the same on every machine. Values of --set stay.
ParameterValues randomParameters(const PluginUnderTest& plugin, std::uint64_t seed, int index);

/// The options that turn `base` into `drawn`: "--set a=1 --set b=false".
std::string difference(const ParameterValues& base, const ParameterValues& drawn);

}  // namespace tolman::conformance
