// SPDX-License-Identifier: BSD-3-Clause
// The linear system of one Gauss-Newton step on a chain with loops. Most nodes are linked only to
// their neighbours on the chain: they are eliminated one by one, in blocks of 3 x 3, and a sparse
// Cholesky factorisation solves for the few nodes at which loops begin and end (knots). Exact, and
// linear in the length of the chain.
#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>
#include <tolman/geometry.hpp>
#include <vector>

#include "planar_link.hpp"

namespace tolman::experience_map {

class ChainSystem {
 public:
  /// The links may join any nodes, but each node k > 0 needs a link from k - 1.
  ChainSystem(std::size_t nodes, const std::vector<PlanarLink>& links);

  /// Sets up the normal equations at `nodes`, the links with their weights.
  void linearise(const std::vector<PlanarPose>& nodes, const std::vector<PlanarLink>& links);
  /// The step (x, y, theta) of each node; node 0 is held. `damping` is a share of the diagonal.
  /// False when the system is singular.
  bool solve(double damping, std::vector<Eigen::Vector3d>& step);

 private:
  using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>;
  /// Two knots joined by loops, and the sum of their blocks.
  struct Joint {
    std::size_t row;  ///< knot, the later one
    std::size_t column;
    Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
  };

  void eliminate();
  void eliminateTail();
  bool solveKnots(std::vector<Eigen::Vector3d>& step);
  void substitute(std::vector<Eigen::Vector3d>& step) const;

  std::vector<Eigen::Matrix3d> information_;  ///< of each link
  std::vector<std::size_t> knots_;            ///< nodes with loops, and node 0; ascending
  std::vector<std::size_t> joint_of_;         ///< of each link that is no step of the chain
  std::vector<Joint> joints_;

  // Normal equations; chain block k joins node k - 1 (rows) and node k (columns).
  std::vector<Eigen::Matrix3d> diagonal_;
  std::vector<Eigen::Matrix3d> chain_;
  std::vector<Eigen::Vector3d> gradient_;

  // The same while it is being eliminated.
  std::vector<Eigen::Matrix3d> pivot_;  ///< inverse for eliminated nodes
  std::vector<Eigen::Matrix3d> left_;   ///< joins a node to the knot before it
  std::vector<Eigen::Vector3d> right_;  ///< right-hand side
  Solver solver_;
  bool analysed_ = false;
};

}  // namespace tolman::experience_map
