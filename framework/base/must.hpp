// SPDX-License-Identifier: BSD-3-Clause
// Results inside a room: a failure is thrown, and is a Result again where the room ends.
#pragma once

#include <utility>

#include "tolman/status.hpp"

namespace tolman {

struct Refused {
  Status status;
};

inline void must(const Status& status) {
  if (!status.isOk()) throw Refused{status};
}
template <class T>
const T& must(const Result<T>& result) {
  must(result.status());
  return result.value();
}
template <class T>
T must(Result<T>&& result) {
  must(result.status());
  return std::move(result).value();
}

/// What `work` returns, or the failure that it threw.
template <class Work>
auto resultOf(Work&& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const Refused& refused) {
    return refused.status;
  }
}

}  // namespace tolman
