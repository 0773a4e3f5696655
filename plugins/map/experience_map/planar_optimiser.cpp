// SPDX-License-Identifier: BSD-3-Clause
// Sets up and solves the Ceres problem.
#include "planar_optimiser.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <array>

#include "planar_link.hpp"

namespace tolman::experience_map {
namespace {

using Block = std::array<double, 3>;

ceres::Solver::Options solverOptions(const OptimiserOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;  // no BLAS, hence no threads
  solver.num_threads = 1;
  solver.max_num_iterations = options.iterations;
  solver.function_tolerance = options.tolerance;
  solver.gradient_tolerance = 1e-12;
  solver.parameter_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  return solver;
}

/// Huber's loss is quadratic up to delta and then loses influence as delta / |f|.
double huberWeight(const PlanarLink& link, const Block& from, const Block& to, double delta) {
  if (!link.robust) return 1;
  const PlanarLinkCost cost(link.pose, whiteningOf(link.covariance));
  const std::array<const double*, 2> nodes = {from.data(), to.data()};
  Eigen::Vector3d residual;
  cost.Evaluate(nodes.data(), residual.data(), nullptr);
  return std::min(1.0, delta / std::max(residual.norm(), 1e-300));
}

}  // namespace

Result<bool> optimise(const OptimiserOptions& options, std::vector<PlanarPose>& nodes,
                      std::vector<PlanarLink>& links) {
  std::vector<Block> blocks;
  blocks.reserve(nodes.size());
  for (const PlanarPose& node : nodes) blocks.push_back({node.x, node.y, node.theta});

  PlanarManifold manifold;
  ceres::HuberLoss huber(options.huber_delta);
  ceres::Problem::Options ownership;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  for (Block& block : blocks) problem.AddParameterBlock(block.data(), 3, &manifold);
  problem.SetParameterBlockConstant(blocks.front().data());
  for (const PlanarLink& link : links) {
    problem.AddResidualBlock(new PlanarLinkCost(link.pose, whiteningOf(link.covariance)),
                             link.robust ? &huber : nullptr, blocks[link.from].data(),
                             blocks[link.to].data());
  }

  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions(options), &problem, &summary);
  if (!summary.IsSolutionUsable()) return Status::failed(summary.message);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    nodes[k] = {blocks[k][0], blocks[k][1], wrapAngle(blocks[k][2])};
  }
  for (PlanarLink& link : links) {
    link.weight = huberWeight(link, blocks[link.from], blocks[link.to], options.huber_delta);
  }
  return summary.termination_type == ceres::CONVERGENCE;
}

}  // namespace tolman::experience_map
