// SPDX-License-Identifier: BSD-3-Clause
#include "host/values.hpp"

#include <fmt/format.h>

namespace tolman::host {

Status statusOf(const ValueProblem& problem) {
  return Status::failed(fmt::format(fmt::runtime(problem.what), problem.field));
}

}  // namespace tolman::host
