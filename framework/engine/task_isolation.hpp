// SPDX-License-Identifier: BSD-3-Clause
// Lets stages that are parallel inside share one pool of threads.
#pragma once

#include <oneapi/tbb/task_arena.h>

namespace tolman::pipeline {

/// Calls `call` and returns its result. While `call` waits for its own parallel loops, its thread
/// takes no tasks of other stages: decoding an image in the meantime would delay the answer and all
/// stages that wait for it.
template <class Call>
auto withoutOtherTasks(Call&& call) {
  return tbb::this_task_arena::isolate(call);
}

}  // namespace tolman::pipeline
