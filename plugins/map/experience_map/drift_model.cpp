// SPDX-License-Identifier: BSD-3-Clause
#include "drift_model.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>

namespace tolman::experience_map {
namespace {

constexpr int kSteady = 3;
using ByDrift = Eigen::Matrix<double, 6, kSteady>;
using Right = Eigen::Matrix<double, 6, 1 + kSteady>;

/// The quadratic energy of a linearised map, in the steps x of its nodes and the steady drift b:
/// |x|_H^2 + 2 x'C b + b'D b + 2 g'x + 2 h'b + energy.
class Linearised {
 public:
  /// `system` is working memory.
  Linearised(ChainSystem<Space>& system, const std::vector<Eigen::Isometry3d>& nodes,
             const std::vector<SpatialLink>& links)
      : system_(system), nodes_(nodes) {
    system_.build(nodes.size(), links);
  }

  /// Linearises at the nodes and marginalises x and b. `links` are those of the constructor, under
  /// other covariances. False when the system is singular.
  bool solve(const std::vector<SpatialLink>& links, const std::vector<double>& lengths,
             double prior) {
    linearise(links, lengths, prior);
    if (!system_.factorise(0) || !system_.solveFor<1 + kSteady>(right_, x_)) return false;
    Eigen::Matrix4d product = Eigen::Matrix4d::Zero();  // -(g, C)' H^-1 (g, C)
    for (std::size_t k = 1; k < x_.size(); ++k) product += right_[k].transpose() * x_[k];
    double least = energy_ + product(0, 0);
    double log_determinant = system_.logDeterminant();
    if (prior > 0) {
      const Eigen::Vector3d gradient = drift_gradient_ + product.block<kSteady, 1>(1, 0);
      const Eigen::LDLT<Eigen::Matrix3d> factors(drift_information_ +
                                                 product.bottomRightCorner<3, 3>());
      steady_ = -factors.solve(gradient);
      least += gradient.dot(steady_);
      log_determinant += factors.vectorD().array().log().sum();
    }
    log_likelihood_ = -0.5 * (least + log_determinant - log_information_);
    return std::isfinite(log_likelihood_);
  }

  double logLikelihood() const { return log_likelihood_; }
  const Eigen::Vector3d& steady() const { return steady_; }

 private:
  void linearise(const std::vector<SpatialLink>& links, const std::vector<double>& lengths,
                 double prior) {
    right_.assign(nodes_.size(), Right::Zero());
    drift_information_.setZero();
    drift_gradient_.setZero();
    steady_.setZero();
    energy_ = 0;
    log_information_ = 0;
    if (prior > 0) {
      drift_information_ = Eigen::Vector3d::Constant(1 / (prior * prior)).asDiagonal();
      log_information_ = -2 * kSteady * std::log(prior);
    }
    system_.takeCovariances(links);
    system_.linearise(nodes_, links, {}, [&](std::size_t k, const LinkDerivatives<Space>& by) {
      add(links[k], k, by, k < lengths.size() ? lengths[k] : 0);
    });
    for (std::size_t k = 0; k < nodes_.size(); ++k) right_[k].col(0) = system_.gradient()[k];
  }

  /// Adds link `k`. A steady drift b over the length l moves the link's end by -l b, which equals a
  /// motion of its beginning by -Ad(link) l b.
  void add(const SpatialLink& link, std::size_t k, const LinkDerivatives<Space>& by,
           double length) {
    const Matrix6d information = link.weight * system_.information()[k];
    energy_ += by.residual.dot(information * by.residual);
    if (length <= 0) return;
    log_information_ += 6 * std::log(link.weight) + system_.logInformation()[k];
    const ByDrift by_drift = -length * by.by_from * adjointSe3(link.pose).leftCols<kSteady>();
    const ByDrift weighted = information * by_drift;
    drift_information_ += by_drift.transpose() * weighted;
    drift_gradient_ += weighted.transpose() * by.residual;
    right_[link.from].rightCols<kSteady>() += by.by_from.transpose() * weighted;
    right_[link.to].rightCols<kSteady>() += by.by_to.transpose() * weighted;
  }

  ChainSystem<Space>& system_;
  const std::vector<Eigen::Isometry3d>& nodes_;
  std::vector<Right> right_;  ///< g and the columns of C, of each node
  std::vector<Right> x_;
  Eigen::Matrix3d drift_information_;  ///< D
  Eigen::Vector3d drift_gradient_;     ///< h
  Eigen::Vector3d steady_;             ///< the most likely b
  double energy_ = 0;
  /// Logarithm of the determinants of the information of odometry links and of the prior of b.
  double log_information_ = 0;
  double log_likelihood_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

SpatialLink withDrift(SpatialLink link, double length, double rotation, const DriftModel& drift) {
  if (length <= 0) return link;
  Vector6d steady = Vector6d::Zero();
  steady.head<kSteady>() = -length * drift.steady;
  link.pose = link.pose * expSe3(steady);
  const double excess = rotation * rotation - drift.rotation * drift.rotation;
  link.covariance.diagonal().tail<3>().array() -= length * length * excess;
  return link;
}

DriftModel learnDrift(const std::vector<Eigen::Isometry3d>& nodes,
                      const std::vector<SpatialLink>& links, const std::vector<double>& lengths,
                      const DriftPrior& prior, ChainSystem<Space>& system) {
  constexpr int kQuarters = 2;  // README.md: a quarter and a sixteenth are tried; chosen, not tuned
  // Standard deviation of the logarithm of the rotation drift under the prior: ln 10. Chosen, not
  // tuned.
  constexpr double kSpread = 2.3;
  DriftModel best;
  best.rotation = prior.rotation;
  double most = -std::numeric_limits<double>::infinity();
  std::vector<SpatialLink> under = links;
  Linearised map(system, nodes, under);
  for (int quarter = 0; quarter <= kQuarters; ++quarter) {
    DriftModel tried;
    tried.rotation = std::ldexp(prior.rotation, -2 * quarter);
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      under[k] = withDrift(links[k], lengths[k], prior.rotation, tried);
    }
    if (!map.solve(under, lengths, prior.steady)) continue;
    const double away = std::log(tried.rotation / prior.rotation) / kSpread;
    const double likelihood = map.logLikelihood() - 0.5 * away * away;
    if (likelihood <= most) continue;
    most = likelihood;
    best = {tried.rotation, map.steady()};
  }
  return best;
}

}  // namespace tolman::experience_map
