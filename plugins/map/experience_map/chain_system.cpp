// SPDX-License-Identifier: BSD-3-Clause
// Elimination from knot to knot, the sparse rest, and the way back.
#include "chain_system.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <utility>

namespace tolman::experience_map {
namespace {

bool isStep(const PlanarLink& link) { return link.to == link.from + 1; }

}  // namespace

ChainSystem::ChainSystem(std::size_t nodes, const std::vector<PlanarLink>& links)
    : diagonal_(nodes),
      chain_(nodes),
      gradient_(nodes),
      pivot_(nodes),
      left_(nodes),
      right_(nodes) {
  knots_.push_back(0);
  for (const PlanarLink& link : links) {
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
  for (const PlanarLink& link : links) {
    if (isStep(link)) {
      joint_of_.push_back(0);
      continue;
    }
    const std::size_t column = knotOf(std::min(link.from, link.to));
    const std::size_t row = knotOf(std::max(link.from, link.to));
    const auto [place, fresh] = seen.try_emplace({row, column}, joints_.size());
    if (fresh) joints_.push_back({row, column, Eigen::Matrix3d::Zero()});
    joint_of_.push_back(place->second);
  }
}

void ChainSystem::linearise(const std::vector<PlanarPose>& nodes,
                            const std::vector<PlanarLink>& links) {
  std::ranges::fill(diagonal_, Eigen::Matrix3d::Zero());
  std::ranges::fill(chain_, Eigen::Matrix3d::Zero());
  std::ranges::fill(gradient_, Eigen::Vector3d::Zero());
  for (Joint& joint : joints_) joint.block.setZero();
  for (std::size_t k = 0; k < links.size(); ++k) {
    const PlanarLink& link = links[k];
    const PlanarPose& from = nodes[link.from];
    const PlanarPose& to = nodes[link.to];
    const LinkDerivatives by = derivativesOf(from, to);
    const Eigen::Matrix3d information = link.weight * information_[k];
    const Eigen::Vector3d pull = information * residualOf(link, from, to);
    const Eigen::Matrix3d from_information = by.by_from.transpose() * information;
    diagonal_[link.from] += from_information * by.by_from;
    diagonal_[link.to] += by.by_to.transpose() * information * by.by_to;
    gradient_[link.from] += by.by_from.transpose() * pull;
    gradient_[link.to] += by.by_to.transpose() * pull;
    const Eigen::Matrix3d across = from_information * by.by_to;  // rows of `from`
    if (isStep(link)) {
      chain_[link.to] += across;
    } else if (link.from > link.to) {
      joints_[joint_of_[k]].block += across;
    } else {
      joints_[joint_of_[k]].block += across.transpose();
    }
  }
}

bool ChainSystem::solve(double damping, std::vector<Eigen::Vector3d>& step) {
  for (std::size_t k = 0; k < diagonal_.size(); ++k) {
    pivot_[k] = diagonal_[k];
    pivot_[k].diagonal() *= 1 + damping;
    right_[k] = -gradient_[k];
  }
  eliminateTail();
  eliminate();
  step.assign(diagonal_.size(), Eigen::Vector3d::Zero());
  if (!solveKnots(step)) return false;
  substitute(step);
  return std::ranges::all_of(step, [](const Eigen::Vector3d& s) { return s.allFinite(); });
}

/// Behind the last knot, from the end.
void ChainSystem::eliminateTail() {
  for (std::size_t k = diagonal_.size() - 1; k > knots_.back(); --k) {
    pivot_[k] = pivot_[k].inverse().eval();
    const Eigen::Matrix3d factor = chain_[k] * pivot_[k];
    pivot_[k - 1] -= factor * chain_[k].transpose();
    right_[k - 1] -= factor * right_[k];
  }
}

/// Between two knots, from the left. Afterwards left_ of a knot joins it to the knot before.
void ChainSystem::eliminate() {
  for (std::size_t knot = 1; knot < knots_.size(); ++knot) {
    const std::size_t first = knots_[knot - 1];
    left_[first + 1] = chain_[first + 1];
    for (std::size_t k = first + 1; k < knots_[knot]; ++k) {
      pivot_[k] = pivot_[k].inverse().eval();
      const Eigen::Matrix3d to_left = left_[k] * pivot_[k];
      const Eigen::Matrix3d to_next = chain_[k + 1].transpose() * pivot_[k];
      pivot_[first] -= to_left * left_[k].transpose();
      pivot_[k + 1] -= to_next * chain_[k + 1];
      left_[k + 1] = -to_left * chain_[k + 1];
      right_[first] -= to_left * right_[k];
      right_[k + 1] -= to_next * right_[k];
    }
  }
}

/// Knot 0 is node 0, which is held, so knot k has the unknowns 3 (k - 1) ...
bool ChainSystem::solveKnots(std::vector<Eigen::Vector3d>& step) {
  if (knots_.size() < 2) return true;
  const auto size = static_cast<Eigen::Index>(3 * (knots_.size() - 1));
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::size_t row, std::size_t column, const Eigen::Matrix3d& block) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (row == column && j > i) continue;
        entries.emplace_back(static_cast<int>(3 * (row - 1)) + i,
                             static_cast<int>(3 * (column - 1)) + j, block(i, j));
      }
    }
  };
  Eigen::VectorXd right(size);
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    add(k, k, pivot_[knots_[k]]);
    if (k > 1) add(k, k - 1, left_[knots_[k]].transpose());
    right.segment<3>(static_cast<Eigen::Index>(3 * (k - 1))) = right_[knots_[k]];
  }
  for (const Joint& joint : joints_) {
    if (joint.column > 0) add(joint.row, joint.column, joint.block);
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!analysed_) solver_.analyzePattern(matrix);
  analysed_ = true;
  solver_.factorize(matrix);
  if (solver_.info() != Eigen::Success) return false;
  const Eigen::VectorXd solution = solver_.solve(right);
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    step[knots_[k]] = solution.segment<3>(static_cast<Eigen::Index>(3 * (k - 1)));
  }
  return true;
}

void ChainSystem::substitute(std::vector<Eigen::Vector3d>& step) const {
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

}  // namespace tolman::experience_map
