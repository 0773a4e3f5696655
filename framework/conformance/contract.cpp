// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/contract.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tolman::conformance {

bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).norm() < 1e-6 * (1 + a.translation().norm());
}

Status checkDt(const Motion& motion, const Frame& frame, const Frame* previous) {
  const std::int64_t passed_ns = previous ? frame.stamp_ns - previous->stamp_ns : 0;
  const double expected = 1e-9 * static_cast<double>(passed_ns);
  if (std::abs(motion.dt - expected) < 1e-6) return Status::ok();
  return Status::failed(fmt::format("dt is {:f} s, the stamps say {:f} s; see setPlanarVelocity()",
                                    motion.dt, expected));
}

}  // namespace tolman::conformance
