// SPDX-License-Identifier: BSD-3-Clause
// The hash of one value, for comparing values that are too large to print.
#pragma once

#include <cstdint>

#include "conformance/test_instance.hpp"

namespace tolman::test {

std::uint64_t hashOf(const auto& value) { return bitHash(value); }

}  // namespace tolman::test
