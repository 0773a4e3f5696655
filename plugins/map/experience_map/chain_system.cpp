// SPDX-License-Identifier: BSD-3-Clause
// Elimination between the knots, factorisation of the knots, and back-substitution.
//
// Products are written so that the left factor is stored by columns (transposed factors are copied
// first), because Eigen vectorises only such products.
#include "chain_system.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "block_cholesky.hpp"
#include "pose_link.hpp"

namespace tolman::experience_map {
namespace {

template <class G>
bool isStep(const PoseLink<G>& link) {
  return link.to == link.from + 1;
}

}  // namespace

template <class G>
void ChainSystem<G>::build(std::size_t nodes, const std::vector<PoseLink<G>>& links) {
  for (auto* blocks : {&diagonal_, &chain_, &pivot_, &left_}) blocks->resize(nodes);
  gradient_.resize(nodes);
  takeCovariances(links);
  joints_.clear();
  knots_ = {0};
  for (const PoseLink<G>& link : links) {
    if (isStep(link)) continue;
    knots_.push_back(link.from);
    knots_.push_back(link.to);
  }
  std::ranges::sort(knots_);
  knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());
  if (knots_.size() < 2) return;
  findJoints(links);
  std::vector<Entry> entries;
  for (std::size_t k = 2; k < knots_.size(); ++k) entries.emplace_back(k - 1, k - 2);
  for (const Joint& joint : joints_) {
    if (joint.column > 0) entries.emplace_back(joint.row - 1, joint.column - 1);
  }
  knot_factors_ = BlockCholesky<G::kSize>(knots_.size() - 1, entries);
}

template <class G>
void ChainSystem<G>::findJoints(const std::vector<PoseLink<G>>& links) {
  const auto knotOf = [&](std::size_t node) {
    return static_cast<std::size_t>(std::ranges::lower_bound(knots_, node) - knots_.begin());
  };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> seen;
  joint_of_.resize(links.size());
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (isStep(links[k])) continue;
    const std::size_t column = knotOf(std::min(links[k].from, links[k].to));
    const std::size_t row = knotOf(std::max(links[k].from, links[k].to));
    const auto [place, fresh] = seen.try_emplace({row, column}, joints_.size());
    if (fresh) joints_.push_back({row, column, Block::Zero()});
    joint_of_[k] = place->second;
  }
}

template <class G>
void ChainSystem<G>::takeCovariances(const std::vector<PoseLink<G>>& links) {
  information_.resize(links.size());
  log_information_.resize(links.size());
  for (std::size_t k = 0; k < links.size(); ++k) {
    information_[k] = informationOf(links[k].covariance, log_information_[k]);
  }
}

template <class G>
void ChainSystem<G>::linearise(const std::vector<Pose>& nodes,
                               const std::vector<PoseLink<G>>& links,
                               std::span<const double> curvatures, const Visit& visit) {
  std::ranges::fill(diagonal_, Block::Zero());
  std::ranges::fill(chain_, Block::Zero());
  std::ranges::fill(gradient_, Step::Zero());
  for (Joint& joint : joints_) joint.block.setZero();
  for (std::size_t k = 0; k < links.size(); ++k) {
    const PoseLink<G>& link = links[k];
    const LinkDerivatives<G> derivatives = derivativesOf(link, nodes[link.from], nodes[link.to]);
    const Step whitened = information_[k] * derivatives.residual;
    Block information = information_[k];
    if (!curvatures.empty() && curvatures[k] > 0) {
      information.noalias() -= (curvatures[k] * whitened) * whitened.transpose();
    }
    add(link, link.weight * information, derivatives, link.weight * whitened, k);
    if (visit) visit(k, derivatives);
  }
}

template <class G>
void ChainSystem<G>::add(const PoseLink<G>& link, const Block& information,
                         const LinkDerivatives<G>& derivatives, const Step& weighted_residual,
                         std::size_t k) {
  const Block from_transposed = derivatives.by_from.transpose();
  const Block to_transposed = derivatives.by_to.transpose();
  const Block weighed_to = information * derivatives.by_to;
  const Block weighed_from = information * derivatives.by_from;
  diagonal_[link.from].noalias() += from_transposed * weighed_from;
  diagonal_[link.to].noalias() += to_transposed * weighed_to;
  gradient_[link.from].noalias() += from_transposed * weighted_residual;
  gradient_[link.to].noalias() += to_transposed * weighted_residual;
  const Block coupling = from_transposed * weighed_to;  // rows of `from`
  if (isStep(link)) {
    chain_[link.to] += coupling;
  } else if (link.from > link.to) {
    joints_[joint_of_[k]].block += coupling;
  } else {
    joints_[joint_of_[k]].block += coupling.transpose();
  }
}

template <class G>
bool ChainSystem<G>::solve(double damping, std::vector<Step>& step) {
  return factorise(damping) && solveFor<1>(gradient_, step);
}

template <class G>
bool ChainSystem<G>::factorise(double damping) {
  for (std::size_t k = 0; k < diagonal_.size(); ++k) {
    pivot_[k] = diagonal_[k];
    pivot_[k].diagonal() *= 1 + damping;
  }
  log_determinant_ = 0;
  return eliminateTail() && eliminate() && factoriseKnots();
}

template <class G>
template <int kColumns>
bool ChainSystem<G>::solveFor(const Columns<kColumns>& right, Columns<kColumns>& x) {
  x.resize(right.size());
  for (std::size_t k = 0; k < right.size(); ++k) x[k] = -right[k];
  reduceRight<kColumns>(x);
  x[0].setZero();  // node 0 is fixed
  solveKnots<kColumns>(x);
  substitute<kColumns>(x);
  return std::ranges::all_of(x, [](const auto& part) { return part.allFinite(); });
}

template <class G>
double ChainSystem<G>::logDeterminant() const {
  return log_determinant_ + (knots_.size() > 1 ? knot_factors_.logDeterminant() : 0);
}

/// Eliminates the nodes after the last knot, from the end.
template <class G>
bool ChainSystem<G>::eliminateTail() {
  for (std::size_t k = diagonal_.size() - 1; k > knots_.back(); --k) {
    if (!invertPositive(pivot_[k], log_determinant_)) return false;
    const Block coupling = chain_[k] * pivot_[k];
    pivot_[k - 1].noalias() -= coupling * chain_[k].transpose();
  }
  return true;
}

/// Eliminates the nodes between two knots, in ascending order. Afterwards left_ of a knot joins it
/// to the knot before.
template <class G>
bool ChainSystem<G>::eliminate() {
  for (std::size_t knot = 1; knot < knots_.size(); ++knot) {
    const std::size_t first = knots_[knot - 1];
    left_[first + 1] = chain_[first + 1];
    for (std::size_t k = first + 1; k < knots_[knot]; ++k) {
      if (!invertPositive(pivot_[k], log_determinant_)) return false;
      const Block back = chain_[k + 1].transpose();
      const Block to_left = left_[k] * pivot_[k];
      const Block to_next = back * pivot_[k];
      pivot_[first].noalias() -= to_left * left_[k].transpose();
      pivot_[k + 1].noalias() -= to_next * chain_[k + 1];
      left_[k + 1].noalias() = -to_left * chain_[k + 1];
    }
  }
  return true;
}

template <class G>
bool ChainSystem<G>::factoriseKnots() {
  if (knots_.size() < 2) return true;
  knot_factors_.setZero();
  std::size_t entry = 0;
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    knot_factors_.diagonal(k - 1) = pivot_[knots_[k]];
    if (k > 1) knot_factors_.add(entry++, left_[knots_[k]].transpose());
  }
  for (const Joint& joint : joints_) {
    if (joint.column > 0) knot_factors_.add(entry++, joint.block);
  }
  return knot_factors_.factorise();
}

/// Applies the eliminations to the right-hand side x.
template <class G>
template <int kColumns>
void ChainSystem<G>::reduceRight(Columns<kColumns>& x) const {
  using Part = Eigen::Matrix<double, G::kSize, kColumns>;
  for (std::size_t k = x.size() - 1; k > knots_.back(); --k) {
    const Part solved = pivot_[k] * x[k];
    x[k - 1].noalias() -= chain_[k] * solved;
  }
  for (std::size_t knot = 1; knot < knots_.size(); ++knot) {
    const std::size_t first = knots_[knot - 1];
    for (std::size_t k = first + 1; k < knots_[knot]; ++k) {
      const Part solved = pivot_[k] * x[k];
      x[first].noalias() -= left_[k] * solved;
      x[k + 1].noalias() -= chain_[k + 1].transpose() * solved;
    }
  }
}

/// Replaces the right-hand sides of the knots by their solutions.
template <class G>
template <int kColumns>
void ChainSystem<G>::solveKnots(Columns<kColumns>& x) const {
  if (knots_.size() < 2) return;
  Columns<kColumns> solution(knots_.size() - 1);
  for (std::size_t k = 1; k < knots_.size(); ++k) solution[k - 1] = x[knots_[k]];
  knot_factors_.solve(solution);
  for (std::size_t k = 1; k < knots_.size(); ++k) x[knots_[k]] = solution[k - 1];
}

/// Replaces the right-hand sides of the eliminated nodes by their solutions.
template <class G>
template <int kColumns>
void ChainSystem<G>::substitute(Columns<kColumns>& x) const {
  using Part = Eigen::Matrix<double, G::kSize, kColumns>;
  for (std::size_t knot = 1; knot < knots_.size(); ++knot) {
    const std::size_t first = knots_[knot - 1];
    for (std::size_t k = knots_[knot] - 1; k > first; --k) {
      Part rest = x[k];
      rest.noalias() -= left_[k].transpose() * x[first];
      rest.noalias() -= chain_[k + 1] * x[k + 1];
      x[k].noalias() = pivot_[k] * rest;
    }
  }
  for (std::size_t k = knots_.back() + 1; k < x.size(); ++k) {
    Part rest = x[k];
    rest.noalias() -= chain_[k].transpose() * x[k - 1];
    x[k].noalias() = pivot_[k] * rest;
  }
}

template class ChainSystem<Plane>;
template class ChainSystem<Space>;
template bool ChainSystem<Space>::solveFor<1>(const Columns<1>&, Columns<1>&);
template bool ChainSystem<Space>::solveFor<6>(const Columns<6>&, Columns<6>&);
template bool ChainSystem<Plane>::solveFor<1>(const Columns<1>&, Columns<1>&);
template bool ChainSystem<Plane>::solveFor<4>(const Columns<4>&, Columns<4>&);

}  // namespace tolman::experience_map
