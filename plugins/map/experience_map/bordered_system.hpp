// SPDX-License-Identifier: BSD-3-Clause
// The steady errors of odometry as unknowns b of the map, next to the poses (path_calibration).
// They correct every odometry link alike.
#pragma once

#include <Eigen/Cholesky>
#include <optional>
#include <path_calibration.hpp>
#include <vector>

#include "chain_system.hpp"
#include "pose_link.hpp"

namespace tolman::experience_map {

template <class G>
inline constexpr int kErrors = G::kSize == 3 ? kPlanarErrors : kSpatialErrors;
template <class G>
using ErrorsOf = Eigen::Matrix<double, kErrors<G>, 1>;
template <class G>
using EffectOf = Eigen::Matrix<double, G::kSize, kErrors<G>>;

inline PlanarPose corrected(const PlanarPose& reported, const Eigen::Vector3d& by) {
  return {reported.x + by.x(), reported.y + by.y(), wrapAngle(reported.theta + by.z())};
}
inline Eigen::Isometry3d corrected(const Eigen::Isometry3d& reported, const Vector6d& by) {
  return reported * expSe3(by);
}

/// Derivative of a corrected link's residual with respect to b. In space a motion of the link's end
/// equals the opposite one of its beginning, seen through the link.
inline EffectOf<Plane> byErrors(const EffectOf<Plane>& effect, const PlanarLink&,
                                const LinkDerivatives<Plane>&) {
  return -effect;
}
inline EffectOf<Space> byErrors(const EffectOf<Space>& effect, const SpatialLink& link,
                                const LinkDerivatives<Space>& derivatives) {
  return derivatives.by_from * (adjointSe3(link.pose) * effect);
}

template <class G>
struct SteadyErrors {
  std::vector<typename G::Pose> reported = {};  ///< of each odometry link, uncorrected
  std::vector<EffectOf<G>> effects = {};        ///< of each odometry link, along its covariance
  ErrorsOf<G> b = ErrorsOf<G>::Zero();
  ErrorsOf<G> precision = ErrorsOf<G>::Ones();  ///< of the prior of each error, whose mean is 0

  /// Energy of the prior.
  double energy() const { return effects.empty() ? 0 : b.dot(precision.cwiseProduct(b)); }
  /// Sets the poses of the odometry links, which are the first of `links`.
  void correct(std::vector<PoseLink<G>>& links) const {
    for (std::size_t k = 0; k < effects.size(); ++k) {
      links[k].pose = corrected(reported[k], effects[k] * b);
    }
  }
};

// The normal equations of the poses x and of the steady errors b of odometry,
//
//   [H  C] [x]     [g]
//   [C' D] [b] = - [h],
//
// where H is the chain's (chain_system). x is eliminated first; b has a few unknowns only.

/// A map: its nodes, links between them (those of odometry first), and the steady errors of
/// odometry. Without effects of errors there are none.
template <class G>
struct PoseGraph {
  std::vector<typename G::Pose> nodes;
  std::vector<PoseLink<G>> links;
  SteadyErrors<G> errors = {};
  std::vector<MatrixOf<G>> assumed = {};  ///< covariances of the links, before they are scaled
};

template <class G>
class BorderedSystem {
 public:
  static constexpr int kCount = kErrors<G>;
  using Step = StepOf<G>;
  using Square = Eigen::Matrix<double, kCount, kCount>;

  void build(std::size_t nodes, const std::vector<PoseLink<G>>& links) {
    chain_.build(nodes, links);
  }
  /// Updates the covariances of the links; their ends must be the same as before.
  void takeCovariances(const std::vector<PoseLink<G>>& links) { chain_.takeCovariances(links); }
  /// Sets up the equations at `nodes` and errors.b; see ChainSystem::linearise(). The poses of
  /// `links` are corrected by `errors`.
  void linearise(const std::vector<typename G::Pose>& nodes, const std::vector<PoseLink<G>>& links,
                 std::span<const double> curvatures, const SteadyErrors<G>& errors);
  /// The step of each node and of b, with the diagonal multiplied by 1 + damping. False when the
  /// system is not positive definite.
  bool solve(double damping, std::vector<Step>& step, ErrorsOf<G>& error_step);
  /// After solve(0): log of the probability of all residuals, up to a constant, with x and b
  /// marginalised to second order and the weights of the links held.
  double logLikelihood() const;
  /// The same with `energy` of the robust losses, in which each loop counts, also a rejected one.
  double logLikelihood(double energy) const;
  /// Covariance of b at `graph`; nothing where the system is singular.
  std::optional<Square> errorCovariance(const PoseGraph<G>& graph) {
    build(graph.nodes.size(), graph.links);
    linearise(graph.nodes, graph.links, {}, graph.errors);
    std::vector<Step> step;
    ErrorsOf<G> error_step;
    if (!bordered_ || !solve(0, step, error_step)) return std::nullopt;
    return factors_.solve(Square::Identity()).eval();
  }
  /// Inverse covariance of each link.
  const std::vector<MatrixOf<G>>& information() const { return chain_.information(); }

 private:
  using Right = Eigen::Matrix<double, G::kSize, 1 + kCount>;
  void add(const PoseLink<G>& link, std::size_t k, const LinkDerivatives<G>& by,
           const EffectOf<G>& effect);

  ChainSystem<G> chain_;
  bool bordered_ = false;     ///< there are errors
  std::vector<Right> right_;  ///< g and the columns of C, of each node
  std::vector<Right> x_;
  Square errors_information_;    ///< D
  ErrorsOf<G> errors_gradient_;  ///< h
  Eigen::LDLT<Square> factors_;  ///< of D - C' H^-1 C
  double log_prior_information_ = 0;
  double energy_ = 0;     ///< at the point of linearisation
  double reduction_ = 0;  ///< of the energy by the step
  double log_information_ =
      0;  ///< log determinants of the information of all links and of the prior
};

/// Factors on the standard deviations that the map assumes.
struct Assumptions {
  double odometry_distance = 1;
  double odometry_turns = 1;
  double loop_distance = 1;
  double loop_turns = 1;
  double errors = 1;  ///< of the prior of the steady errors of turning
  friend bool operator==(const Assumptions&, const Assumptions&) = default;
};

/// The covariance of a link under these factors.
template <class G>
MatrixOf<G> scaled(const MatrixOf<G>& covariance, double distance, double turns) {
  constexpr int kLengths = G::kSize == 3 ? 2 : 3;  // the first coordinates of a step
  StepOf<G> factors = StepOf<G>::Constant(turns);
  factors.template head<kLengths>().setConstant(distance);
  return factors.asDiagonal() * covariance * factors.asDiagonal();
}

/// Sets the covariances and the prior of `graph` to those under these assumptions.
template <class G>
void assume(const Assumptions& assumed, PoseGraph<G>& graph);

/// Empirical Bayes: returns the assumptions, factors of two from `assumed`, under which the loops
/// are most likely (a local maximum), and makes them.
template <class G>
Assumptions learnAssumptions(Assumptions assumed, PoseGraph<G>& graph, BorderedSystem<G>& system);

/// Log of the posterior probability of the assumptions at an optimum of this energy.
template <class G>
double logPosterior(const Assumptions& assumed, const PoseGraph<G>& graph, double energy,
                    BorderedSystem<G>& system);

extern template class BorderedSystem<Plane>;
extern template class BorderedSystem<Space>;

}  // namespace tolman::experience_map
