// SPDX-License-Identifier: BSD-3-Clause
// Frames without images, at 10 Hz.
#pragma once

#include "tolman/records.hpp"

namespace tolman::test {

inline Frame frameAt(std::int64_t index) {
  Frame frame;
  frame.frame = index;
  frame.stamp_ns = index * 100'000'000;
  return frame;
}

}  // namespace tolman::test
