// SPDX-License-Identifier: BSD-3-Clause
// A minimal host for direct_sparse.
#pragma once

#include "direct_sparse.hpp"
#include "support/odometry_host.hpp"

namespace tolman::test {

class Host : public OdometryHost<direct_sparse::DirectSparse> {
 public:
  explicit Host(const CameraRig& rig, ParameterValues values = {},
                direct_sparse::Cameras cameras = direct_sparse::Cameras::Stereo)
      : OdometryHost(rig, std::move(values), cameras) {}
};

}  // namespace tolman::test
