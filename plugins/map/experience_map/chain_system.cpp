// SPDX-License-Identifier: BSD-3-Clause
// Elimination from knot to knot, the sparse rest, and the way back.
#include "chain_system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <utility>

#include "planar_link.hpp"
#include "spatial_link.hpp"

namespace tolman::experience_map {
namespace {

template <class G>
bool isStep(const PoseLink<G>& link) {
  return link.to == link.from + 1;
}

}  // namespace

template <class G>
ChainSystem<G>::ChainSystem(std::size_t nodes, const std::vector<PoseLink<G>>& links)
    : diagonal_(nodes),
      chain_(nodes),
      gradient_(nodes),
      pivot_(nodes),
      left_(nodes),
      right_(nodes) {
  knots_.push_back(0);
  for (const PoseLink<G>& link : links) {
    information_.push_back(informationOf(link.covariance));
    if (isStep(link)) continue;
    knots_.push_back(link.from);
    knots_.push_back(link.to);
  }
  std::ranges::sort(knots_);
  knots_.erase(std::unique(knots_.begin(), knots_.end()), knots_.end());

  const auto knotOf = [&](std::size_t node) {
    return static_cast<std::size_t>(std::ranges::lower_bound(knots_, node) - knots_.begin());
  };
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> seen;
  for (const PoseLink<G>& link : links) {
    if (isStep(link)) {
      joint_of_.push_back(0);
      continue;
    }
    const std::size_t column = knotOf(std::min(link.from, link.to));
    const std::size_t row = knotOf(std::max(link.from, link.to));
    const auto [place, fresh] = seen.try_emplace({row, column}, joints_.size());
    if (fresh) joints_.push_back({row, column, Block::Zero()});
    joint_of_.push_back(place->second);
  }
}

template <class G>
void ChainSystem<G>::linearise(const std::vector<Pose>& nodes,
                               const std::vector<PoseLink<G>>& links) {
  std::ranges::fill(diagonal_, Block::Zero());
  std::ranges::fill(chain_, Block::Zero());
  std::ranges::fill(gradient_, Step::Zero());
  for (Joint& joint : joints_) joint.block.setZero();
  for (std::size_t k = 0; k < links.size(); ++k) {
    const PoseLink<G>& link = links[k];
    const Pose& from = nodes[link.from];
    const Pose& to = nodes[link.to];
    const LinkDerivatives<G> by = derivativesOf(link, from, to);
    const Block information = link.weight * information_[k];
    const Step pull = information * residualOf(link, from, to);
    const Block from_information = by.by_from.transpose() * information;
    diagonal_[link.from] += from_information * by.by_from;
    diagonal_[link.to] += by.by_to.transpose() * information * by.by_to;
    gradient_[link.from] += by.by_from.transpose() * pull;
    gradient_[link.to] += by.by_to.transpose() * pull;
    const Block across = from_information * by.by_to;  // rows of `from`
    if (isStep(link)) {
      chain_[link.to] += across;
    } else if (link.from > link.to) {
      joints_[joint_of_[k]].block += across;
    } else {
      joints_[joint_of_[k]].block += across.transpose();
    }
  }
}

template <class G>
bool ChainSystem<G>::solve(double damping, std::vector<Step>& step) {
  for (std::size_t k = 0; k < diagonal_.size(); ++k) {
    pivot_[k] = diagonal_[k];
    pivot_[k].diagonal() *= 1 + damping;
    right_[k] = -gradient_[k];
  }
  eliminateTail();
  eliminate();
  step.assign(diagonal_.size(), Step::Zero());
  if (!solveKnots(step)) return false;
  substitute(step);
  return std::ranges::all_of(step, [](const Step& s) { return s.allFinite(); });
}

/// Behind the last knot, from the end.
template <class G>
void ChainSystem<G>::eliminateTail() {
  for (std::size_t k = diagonal_.size() - 1; k > knots_.back(); --k) {
    pivot_[k] = pivot_[k].inverse().eval();
    const Block factor = chain_[k] * pivot_[k];
    pivot_[k - 1] -= factor * chain_[k].transpose();
    right_[k - 1] -= factor * right_[k];
  }
}

/// Between two knots, from the left. Afterwards left_ of a knot joins it to the knot before.
template <class G>
void ChainSystem<G>::eliminate() {
  for (std::size_t knot = 1; knot < knots_.size(); ++knot) {
    const std::size_t first = knots_[knot - 1];
    left_[first + 1] = chain_[first + 1];
    for (std::size_t k = first + 1; k < knots_[knot]; ++k) {
      pivot_[k] = pivot_[k].inverse().eval();
      const Block to_left = left_[k] * pivot_[k];
      const Block to_next = chain_[k + 1].transpose() * pivot_[k];
      pivot_[first] -= to_left * left_[k].transpose();
      pivot_[k + 1] -= to_next * chain_[k + 1];
      left_[k + 1] = -to_left * chain_[k + 1];
      right_[first] -= to_left * right_[k];
      right_[k + 1] -= to_next * right_[k];
    }
  }
}

/// The system of the knots. Knot 0 is node 0, which is held, so knot k
/// has the unknowns from G::kSize (k - 1) on.
template <class G>
Eigen::SparseMatrix<double> ChainSystem<G>::knotMatrix(Eigen::VectorXd& right) const {
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t row, std::size_t column, const Block& block) {
    for (int i = 0; i < G::kSize; ++i) {
      for (int j = 0; j < G::kSize; ++j) {
        if (row == column && j > i) continue;
        entries.emplace_back(static_cast<int>(indexOf(row)) + i,
                             static_cast<int>(indexOf(column)) + j, block(i, j));
      }
    }
  };
  right.resize(indexOf(knots_.size()));
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    add(k, k, pivot_[knots_[k]]);
    if (k > 1) add(k, k - 1, left_[knots_[k]].transpose());
    right.template segment<G::kSize>(indexOf(k)) = right_[knots_[k]];
  }
  for (const Joint& joint : joints_) {
    if (joint.column > 0) add(joint.row, joint.column, joint.block);
  }
  Eigen::SparseMatrix<double> matrix(right.size(), right.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <class G>
bool ChainSystem<G>::solveKnots(std::vector<Step>& step) {
  if (knots_.size() < 2) return true;
  Eigen::VectorXd right;
  const Eigen::SparseMatrix<double> matrix = knotMatrix(right);
  if (!analysed_) solver_.analyzePattern(matrix);
  analysed_ = true;
  solver_.factorize(matrix);
  if (solver_.info() != Eigen::Success) return false;
  const Eigen::VectorXd solution = solver_.solve(right);
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    step[knots_[k]] = solution.template segment<G::kSize>(indexOf(k));
  }
  return true;
}

template <class G>
void ChainSystem<G>::substitute(std::vector<Step>& step) const {
  for (std::size_t knot = 1; knot < knots_.size(); ++knot) {
    const std::size_t first = knots_[knot - 1];
    for (std::size_t k = knots_[knot] - 1; k > first; --k) {
      step[k] = pivot_[k] *
                (right_[k] - left_[k].transpose() * step[first] - chain_[k + 1] * step[k + 1]);
    }
  }
  for (std::size_t k = knots_.back() + 1; k < step.size(); ++k) {
    step[k] = pivot_[k] * (right_[k] - chain_[k].transpose() * step[k - 1]);
  }
}

template class ChainSystem<Plane>;
template class ChainSystem<Space>;

}  // namespace tolman::experience_map
