// SPDX-License-Identifier: BSD-3-Clause
// Requirements of roles.hpp and records.hpp on answers that the host does not check at every frame.
#pragma once

#include "tolman/records.hpp"
#include "tolman/roles.hpp"

namespace tolman::conformance {

/// dt is the time since the previous frame, 0 for the first.
Status checkDt(const Motion& motion, const Frame& frame, const Frame* previous);

/// Whether two poses are equal up to rounding.
bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b);

}  // namespace tolman::conformance
