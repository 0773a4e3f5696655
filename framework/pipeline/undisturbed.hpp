// SPDX-License-Identifier: BSD-3-Clause
// Stages that are parallel inside, side by side in one pool of threads.
#pragma once

#include <oneapi/tbb/task_arena.h>

namespace tolman::pipeline {

/// What `call` returns. While it waits for parallel loops of its own it begins no other stage's
/// work: decoding an image in the midst of an answer would hold up everything behind the answer.
template <class Call>
auto undisturbed(Call&& call) {
  return tbb::this_task_arena::isolate(call);
}

}  // namespace tolman::pipeline
