// SPDX-License-Identifier: BSD-3-Clause
// The paper's energy over all nodes and links of the plane, minimised by Ceres.
#pragma once

#include <cstddef>
#include <tolman/geometry.hpp>
#include <tolman/status.hpp>
#include <vector>

namespace tolman::experience_map {

struct PlanarLink {
  std::size_t from = 0;
  std::size_t to = 0;
  PlanarPose pose;             ///< of `to`, seen from `from`
  Eigen::Matrix3d covariance;  ///< along the axes of `from`
  bool robust = true;          ///< under the Huber loss; otherwise plain least squares
  double weight = 1;           ///< result: what the loss left of its influence, in (0, 1]
};

struct OptimiserOptions {
  int iterations = 100;
  double huber_delta = 1;
  double tolerance = 1e-10;  ///< relative change of the energy that ends the search
};

/// min over e of 1/2 sum rho(|f(e_i, e_j, e_ij)|^2), node 0 held. Improves `nodes` from where they
/// are and sets the weights; leaves both alone when it fails. Says whether it converged. One
/// thread, no BLAS: bitwise the same on every run.
Result<bool> optimise(const OptimiserOptions& options, std::vector<PlanarPose>& nodes,
                      std::vector<PlanarLink>& links);

}  // namespace tolman::experience_map
