// SPDX-License-Identifier: BSD-3-Clause
// The hash of one value, for comparing values that are too large to print.
#pragma once

#include <cstdint>

#include "conformance/transcript.hpp"

namespace tolman::test {

std::uint64_t hashOf(const auto& value) {
  conformance::BitHash hash;
  hash.add(value);
  return hash.value();
}

}  // namespace tolman::test
