// SPDX-License-Identifier: BSD-3-Clause
// The linear system of one Gauss-Newton step on a chain with loops. Most nodes are linked only to
// their neighbours on the chain: they are eliminated one by one, in blocks of 3 x 3 (6 x 6 in
// space), and a sparse Cholesky factorisation solves for the few nodes at which loops begin and end
// (knots). Exact, and linear in the length of the chain.
#pragma once

#include <Eigen/SparseCholesky>
#include <cstddef>
#include <tolman/geometry.hpp>
#include <vector>

#include "pose_link.hpp"

namespace tolman::experience_map {

template <class G>
class ChainSystem {
 public:
  using Pose = typename G::Pose;
  using Step = StepOf<G>;

  /// The links may join any nodes, but each node k > 0 needs a link from k - 1.
  ChainSystem(std::size_t nodes, const std::vector<PoseLink<G>>& links);

  /// Sets up the normal equations at `nodes`, the links with their weights.
  void linearise(const std::vector<Pose>& nodes, const std::vector<PoseLink<G>>& links);
  /// The step of each node; node 0 is held. `damping` is a share of the diagonal.
  /// False when the system is singular.
  bool solve(double damping, std::vector<Step>& step);

 private:
  using Block = MatrixOf<G>;
  using Solver = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>;
  /// Two knots joined by loops, and the sum of their blocks.
  struct Joint {
    std::size_t row;  ///< knot, the later one
    std::size_t column;
    Block block = Block::Zero();
  };

  void eliminate();
  void eliminateTail();
  static Eigen::Index indexOf(std::size_t knot) {
    return static_cast<Eigen::Index>(G::kSize * (knot - 1));
  }
  Eigen::SparseMatrix<double> knotMatrix(Eigen::VectorXd& right) const;
  bool solveKnots(std::vector<Step>& step);
  void substitute(std::vector<Step>& step) const;

  std::vector<Block> information_;     ///< of each link
  std::vector<std::size_t> knots_;     ///< nodes with loops, and node 0; ascending
  std::vector<std::size_t> joint_of_;  ///< of each link that is no step of the chain
  std::vector<Joint> joints_;

  // Normal equations; chain block k joins node k - 1 (rows) and node k (columns).
  std::vector<Block> diagonal_;
  std::vector<Block> chain_;
  std::vector<Step> gradient_;

  // The same while it is being eliminated.
  std::vector<Block> pivot_;  ///< inverse for eliminated nodes
  std::vector<Block> left_;   ///< joins a node to the knot before it
  std::vector<Step> right_;   ///< right-hand side
  Solver solver_;
  bool analysed_ = false;
};

extern template class ChainSystem<Plane>;
extern template class ChainSystem<Space>;

}  // namespace tolman::experience_map
