// SPDX-License-Identifier: BSD-3-Clause
#include "ceres_optimiser.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>

#include "ceres_poses.hpp"
#include "planar_link.hpp"
#include "spatial_link.hpp"

namespace tolman::experience_map {
namespace {

template <class G>
class PoseManifold final : public ceres::Manifold {
 public:
  using Pose = CeresPose<G>;
  static constexpr int kBlock = Pose::kSize;
  static constexpr int kStep = G::kSize;

  int AmbientSize() const override { return kBlock; }
  int TangentSize() const override { return kStep; }
  bool Plus(const double* x, const double* delta, double* sum) const override {
    const auto to = moved(Pose::poseOf(x), StepOf<G>(Eigen::Map<const StepOf<G>>(delta)));
    const auto block = Pose::blockOf(to);
    std::copy(block.begin(), block.end(), sum);
    return true;
  }
  bool PlusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<RowMatrix<kBlock, kStep>>{jacobian} = Pose::blockByStep(x);
    return true;
  }
  bool Minus(const double* y, const double* x, double* difference) const override {
    Eigen::Map<StepOf<G>>{difference} = Pose::between(Pose::poseOf(x), Pose::poseOf(y));
    return true;
  }
  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<RowMatrix<kStep, kBlock>>{jacobian} = Pose::stepByBlock(x);
    return true;
  }
};

/// residualOf() of a link, whitened.
template <class G>
class LinkCost final
    : public ceres::SizedCostFunction<G::kSize, CeresPose<G>::kSize, CeresPose<G>::kSize> {
 public:
  explicit LinkCost(const PoseLink<G>& link)
      : link_(link),
        whitening_(Eigen::LLT<MatrixOf<G>>(informationOf(link.covariance)).matrixU()) {}

  bool Evaluate(double const* const* ends, double* residuals, double** jacobians) const override {
    using Pose = CeresPose<G>;
    using Jacobian = Eigen::Map<RowMatrix<G::kSize, Pose::kSize>>;
    const auto from = Pose::poseOf(ends[0]);
    const auto to = Pose::poseOf(ends[1]);
    Eigen::Map<StepOf<G>>{residuals} = whitening_ * residualOf(link_, from, to);
    if (jacobians == nullptr) return true;
    const LinkDerivatives<G> by = derivativesOf(link_, from, to);
    if (jacobians[0] != nullptr) {
      Jacobian{jacobians[0]} = whitening_ * by.by_from * Pose::stepByBlock(ends[0]);
    }
    if (jacobians[1] != nullptr) {
      Jacobian{jacobians[1]} = whitening_ * by.by_to * Pose::stepByBlock(ends[1]);
    }
    return true;
  }

 private:
  const PoseLink<G>& link_;
  MatrixOf<G> whitening_;
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

ceres::Solver::Options solverOptions(const OptimiserOptions& options) {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;  // no BLAS, hence no threads
  solver.num_threads = 1;
  solver.max_num_iterations = options.iterations;
  solver.function_tolerance = options.tolerance;
  solver.gradient_tolerance = 1e-12;  // so small that function_tolerance decides
  solver.parameter_tolerance = 1e-12;
  solver.logging_type = ceres::SILENT;
  return solver;
}

template <class G>
class CeresProblem {
 public:
  using Pose = typename G::Pose;
  using PoseLinks = std::vector<PoseLink<G>>;
  using Block = typename CeresPose<G>::Block;

  CeresProblem(const OptimiserOptions& options, const std::vector<Pose>& nodes,
               const PoseLinks& links)
      : options_(options), links_(links) {
    for (const Pose& node : nodes) blocks_.push_back(CeresPose<G>::blockOf(node));
    for (const PoseLink<G>& link : links) costs_.emplace_back(link);
  }

  ceres::Solver::Summary solve(double mu) {
    const auto loss = lossOf(options_, mu);
    ceres::Problem::Options ownership;
    ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    for (Block& block : blocks_)
      problem.AddParameterBlock(block.data(), CeresPose<G>::kSize, &manifold_);
    problem.SetParameterBlockConstant(blocks_.front().data());
    for (std::size_t k = 0; k < links_.size(); ++k) {
      problem.AddResidualBlock(&costs_[k], links_[k].robust ? loss.get() : nullptr,
                               blocks_[links_[k].from].data(), blocks_[links_[k].to].data());
    }
    ceres::Solver::Summary summary;
    ceres::Solve(solverOptions(options_), &problem, &summary);
    return summary;
  }

  /// Decreasing values of mu for graduated non-convexity.
  std::vector<double> easing() const {
    double worst = 0;
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (links_[k].robust) worst = std::max(worst, chi(k));
    }
    constexpr double kMuFactor = 1.4;  // as in the paper by Yang et al.
    std::vector<double> mus;
    for (double mu = 2 * worst / (options_.delta * options_.delta); mu > 1; mu /= kMuFactor) {
      mus.push_back(mu);
    }
    return mus;
  }

  void copyResult(std::vector<Pose>& nodes, PoseLinks& links) const {
    const auto loss = lossOf(options_, 1);
    for (std::size_t k = 0; k < links.size(); ++k) {
      std::array<double, 3> rho{1, 1, 0};
      if (links[k].robust) loss->Evaluate(chi(k), rho.data());
      links[k].weight = rho[1];
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      nodes[k] = CeresPose<G>::poseOf(blocks_[k].data());
    }
  }

 private:
  double chi(std::size_t k) const {
    const auto poseOf = [&](std::size_t node) {
      return CeresPose<G>::poseOf(blocks_[node].data());
    };
    const PoseLink<G>& link = links_[k];
    const StepOf<G> error = residualOf(link, poseOf(link.from), poseOf(link.to));
    return error.dot(informationOf(link.covariance) * error);
  }
  OptimiserOptions options_;
  const PoseLinks& links_;
  std::vector<Block> blocks_;
  std::deque<LinkCost<G>> costs_;
  PoseManifold<G> manifold_;
};

}  // namespace

template <class G>
Result<OptimiserOutcome> optimiseWithCeres(const OptimiserOptions& options,
                                           std::vector<typename G::Pose>& nodes,
                                           std::vector<PoseLink<G>>& links) {
  CeresProblem<G> problem(options, nodes, links);
  if (options.annealed && options.loss == Loss::GemanMcclure) {
    for (const double mu : problem.easing()) (void)problem.solve(mu);
  }
  const ceres::Solver::Summary summary = problem.solve(1);
  if (!summary.IsSolutionUsable()) return Status::failed(summary.message);
  problem.copyResult(nodes, links);
  return OptimiserOutcome{summary.termination_type == ceres::CONVERGENCE, 2 * summary.final_cost};
}

template Result<OptimiserOutcome> optimiseWithCeres<Plane>(const OptimiserOptions&,
                                                           std::vector<PlanarPose>&,
                                                           std::vector<PlanarLink>&);
template Result<OptimiserOutcome> optimiseWithCeres<Space>(const OptimiserOptions&,
                                                           std::vector<Eigen::Isometry3d>&,
                                                           std::vector<SpatialLink>&);

}  // namespace tolman::experience_map
