// SPDX-License-Identifier: BSD-3-Clause
// The linear system of one Gauss-Newton step on a chain with loops. Most nodes are linked only to
// their neighbours on the chain: they are eliminated one by one, in blocks of 3 x 3 (6 x 6 in
// space), and a sparse Cholesky factorisation solves for the few others, at which loops begin or
// end: the knots. The solution is exact, and the time of the elimination is linear in the length of
// the chain.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <tolman/geometry.hpp>
#include <vector>

#include "block_cholesky.hpp"
#include "pose_link.hpp"

namespace tolman::experience_map {

template <class G>
class ChainSystem {
 public:
  using Pose = typename G::Pose;
  using Step = StepOf<G>;
  /// Called with the index and the derivatives of a link.
  using Visit = std::function<void(std::size_t, const LinkDerivatives<G>&)>;
  /// kColumns right-hand sides or solutions: a block of rows for each node.
  template <int kColumns>
  using Columns = std::vector<Eigen::Matrix<double, G::kSize, kColumns>>;

  ChainSystem() = default;
  ChainSystem(std::size_t nodes, const std::vector<PoseLink<G>>& links) { build(nodes, links); }

  /// Prepares for these nodes and links. Reuses the memory of an earlier system, because the first
  /// use of new memory takes longer than a step. The links may join any nodes, but each node k > 0
  /// needs a link from k - 1.
  void build(std::size_t nodes, const std::vector<PoseLink<G>>& links);

  /// Updates the covariances of the links; their ends must be the same as before.
  void takeCovariances(const std::vector<PoseLink<G>>& links);
  /// Sets up the normal equations at `nodes`, with the weights of the links. `curvatures`, if not
  /// empty, has the curvature of the robust loss for each link: the information W of a link with
  /// residual r becomes W - curvature * W r r' W. `visit` is called for each link.
  void linearise(const std::vector<Pose>& nodes, const std::vector<PoseLink<G>>& links,
                 std::span<const double> curvatures = {}, const Visit& visit = {});
  /// Eliminates and factorises, with the diagonal multiplied by 1 + damping. False when the system
  /// is not positive definite.
  bool factorise(double damping);
  /// factorise(), then computes the step of each node; node 0 is fixed.
  bool solve(double damping, std::vector<Step>& step);
  /// Solves H x = -right with the factorised H, for right-hand sides of the caller.
  template <int kColumns>
  bool solveFor(const Columns<kColumns>& right, Columns<kColumns>& x);
  /// Logarithm of the determinant of the factorised system, damping included.
  double logDeterminant() const;
  const std::vector<Step>& gradient() const { return gradient_; }
  /// Inverse covariance of each link.
  const std::vector<MatrixOf<G>>& information() const { return information_; }
  /// Logarithm of the determinant of each link's information.
  const std::vector<double>& logInformation() const { return log_information_; }

 private:
  using Block = MatrixOf<G>;
  using Entry = typename BlockCholesky<G::kSize>::Entry;
  /// Two knots joined by loops, and the sum of their blocks.
  struct Joint {
    std::size_t row;  ///< knot, the later one
    std::size_t column;
    Block block = Block::Zero();
  };

  void findJoints(const std::vector<PoseLink<G>>& links);
  void add(const PoseLink<G>& link, const Block& information, const LinkDerivatives<G>& derivatives,
           const Step& weighted_residual, std::size_t k);
  bool eliminateTail();
  bool eliminate();
  bool factoriseKnots();
  template <int kColumns>
  void reduceRight(Columns<kColumns>& x) const;
  template <int kColumns>
  void solveKnots(Columns<kColumns>& x) const;
  template <int kColumns>
  void substitute(Columns<kColumns>& x) const;

  std::vector<Block> information_;  ///< of each link
  std::vector<double> log_information_;
  std::vector<std::size_t> knots_;     ///< nodes with loop links, and node 0; ascending
  std::vector<std::size_t> joint_of_;  ///< joint of each link that is not of the chain
  std::vector<Joint> joints_;

  // Normal equations; chain block k joins node k - 1 (rows) and node k (columns).
  std::vector<Block> diagonal_;
  std::vector<Block> chain_;
  std::vector<Step> gradient_;

  // The same after the elimination.
  std::vector<Block> pivot_;    ///< inverse for eliminated nodes
  std::vector<Block> left_;     ///< joins a node to the knot before it
  double log_determinant_ = 0;  ///< of the eliminated nodes
  /// Factorisation of the system of the knots. Knot 0 is node 0, which is fixed, so row k belongs
  /// to knot k + 1. The entries are those of neighbouring knots, then those of the joints.
  BlockCholesky<G::kSize> knot_factors_;
};

extern template class ChainSystem<Plane>;
extern template class ChainSystem<Space>;

}  // namespace tolman::experience_map
