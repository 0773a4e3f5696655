// SPDX-License-Identifier: BSD-3-Clause
// How a source ends.
#pragma once

#include "tolman/context.hpp"
#include "tolman/status.hpp"

namespace tolman::pipeline {

/// Whether a source without a next frame has not failed: it is at its end, or noticed itself that
/// the run was interrupted.
inline bool isEndOfInput(const Status& status, const Cancellation& cancellation) {
  return status.code() == StatusCode::EndOfStream ||
         (status.code() == StatusCode::Cancelled && cancellation.requested());
}

}  // namespace tolman::pipeline
