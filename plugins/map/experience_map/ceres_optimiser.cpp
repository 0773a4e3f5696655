// SPDX-License-Identifier: BSD-3-Clause
#include "ceres_optimiser.hpp"

#include <ceres/loss_function.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>

namespace tolman::experience_map {
namespace {

using Block = std::array<double, 3>;
using RowMatrix3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

PlanarPose poseOf(const double* block) { return {block[0], block[1], block[2]}; }

/// (x m, y m, theta rad), theta kept in [-pi, pi) (paper, "s.t.").
class PlanarManifold final : public ceres::Manifold {
 public:
  int AmbientSize() const override { return 3; }
  int TangentSize() const override { return 3; }
  bool Plus(const double* x, const double* delta, double* sum) const override {
    sum[0] = x[0] + delta[0];
    sum[1] = x[1] + delta[1];
    sum[2] = wrapAngle(x[2] + delta[2]);
    return true;
  }
  bool PlusJacobian(const double*, double* jacobian) const override { return identity(jacobian); }
  bool Minus(const double* y, const double* x, double* difference) const override {
    difference[0] = y[0] - x[0];
    difference[1] = y[1] - x[1];
    difference[2] = wrapAngle(y[2] - x[2]);
    return true;
  }
  bool MinusJacobian(const double*, double* jacobian) const override { return identity(jacobian); }

 private:
  static bool identity(double* jacobian) {
    Eigen::Map<RowMatrix3d>(jacobian).setIdentity();
    return true;
  }
};

/// residualOf() of a link, whitened.
class LinkCost final : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  explicit LinkCost(const PlanarLink& link)
      : link_(link),
        whitening_(Eigen::LLT<Eigen::Matrix3d>(informationOf(link.covariance)).matrixU()) {}

  bool Evaluate(double const* const* ends, double* residuals, double** jacobians) const override {
    const PlanarPose from = poseOf(ends[0]);
    const PlanarPose to = poseOf(ends[1]);
    Eigen::Map<Eigen::Vector3d>{residuals} = whitening_ * residualOf(link_, from, to);
    if (jacobians == nullptr) return true;
    const LinkDerivatives derivatives = derivativesOf(from, to);
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMatrix3d>{jacobians[0]} = whitening_ * derivatives.by_from;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<RowMatrix3d>{jacobians[1]} = whitening_ * derivatives.by_to;
    }
    return true;
  }

 private:
  const PlanarLink& link_;
  Eigen::Matrix3d whitening_;
};

/// rho(s) = mu c^2 s / (mu c^2 + s); mu = 1 is Geman-McClure, mu > 1 more convex (Yang et al.
/// 2020).
class GemanMcclureLoss final : public ceres::LossFunction {
 public:
  GemanMcclureLoss(double scale, double mu) : bound_(mu * scale * scale) {}
  void Evaluate(double s, double rho[3]) const override {
    const double root = bound_ / (bound_ + s);
    rho[0] = s * root;
    rho[1] = root * root;
    rho[2] = -2 * root * root / (bound_ + s);
  }

 private:
  double bound_;
};

std::unique_ptr<ceres::LossFunction> lossOf(const OptimiserOptions& options, double mu) {
  if (options.loss == Loss::Huber) return std::make_unique<ceres::HuberLoss>(options.delta);
  return std::make_unique<GemanMcclureLoss>(options.delta, mu);
}

double chiSquare(const PlanarLink& link, const Block& from, const Block& to) {
  const Eigen::Vector3d error = residualOf(link, poseOf(from.data()), poseOf(to.data()));
  return error.dot(informationOf(link.covariance) * error);
}

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

class CeresProblem {
 public:
  CeresProblem(const OptimiserOptions& options, const std::vector<PlanarPose>& nodes,
               const std::vector<PlanarLink>& links)
      : options_(options), links_(links) {
    for (const PlanarPose& node : nodes) blocks_.push_back({node.x, node.y, node.theta});
    for (const PlanarLink& link : links) costs_.emplace_back(link);
  }

  ceres::Solver::Summary solve(double mu) {
    const auto loss = lossOf(options_, mu);
    ceres::Problem::Options ownership;
    ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    for (Block& block : blocks_) problem.AddParameterBlock(block.data(), 3, &manifold_);
    problem.SetParameterBlockConstant(blocks_.front().data());
    for (std::size_t k = 0; k < links_.size(); ++k) {
      problem.AddResidualBlock(&costs_[k], links_[k].robust ? loss.get() : nullptr,
                               blocks_[links_[k].from].data(), blocks_[links_[k].to].data());
    }
    ceres::Solver::Summary summary;
    ceres::Solve(solverOptions(options_), &problem, &summary);
    return summary;
  }

  /// Falling values of mu for graduated non-convexity.
  std::vector<double> easing() const {
    double worst = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (links_[k].robust) worst = std::max(worst, chi(k));
    }
    constexpr double kEase = 1.4;  // factor of mu, as in the paper by Yang et al.
    std::vector<double> mus;
    for (double mu = 2 * worst / (options_.delta * options_.delta); mu > 1; mu /= kEase) {
      mus.push_back(mu);
    }
    return mus;
  }

  void copyResult(std::vector<PlanarPose>& nodes, std::vector<PlanarLink>& links) const {
    const auto loss = lossOf(options_, 1);
    for (std::size_t k = 0; k < links.size(); ++k) {
      std::array<double, 3> rho{1, 1, 0};
      if (links[k].robust) loss->Evaluate(chi(k), rho.data());
      links[k].weight = rho[1];
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] = poseOf(blocks_[k].data());
  }

 private:
  double chi(std::size_t k) const {
    return chiSquare(links_[k], blocks_[links_[k].from], blocks_[links_[k].to]);
  }
  OptimiserOptions options_;
  const std::vector<PlanarLink>& links_;
  std::vector<Block> blocks_;
  std::deque<LinkCost> costs_;
  PlanarManifold manifold_;
};

}  // namespace

Result<OptimiserOutcome> optimiseWithCeres(const OptimiserOptions& options,
                                           std::vector<PlanarPose>& nodes,
                                           std::vector<PlanarLink>& links) {
  CeresProblem problem(options, nodes, links);
  if (options.annealed && options.loss == Loss::GemanMcclure) {
    for (const double mu : problem.easing()) (void)problem.solve(mu);
  }
  const ceres::Solver::Summary summary = problem.solve(1);
  if (!summary.IsSolutionUsable()) return Status::failed(summary.message);
  problem.copyResult(nodes, links);
  return OptimiserOutcome{summary.termination_type == ceres::CONVERGENCE, 2 * summary.final_cost};
}

}  // namespace tolman::experience_map
