// SPDX-License-Identifier: BSD-3-Clause
// Steady errors and noise of odometry against the probability of the loops' residuals, computed
// densely and with finite differences.
#include "bordered_system.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <tolman/context.hpp>

#include "uncertain_pose.hpp"

namespace tolman::experience_map {
namespace {

constexpr double kNoise = 0.008;  // rad of a link, as assumed
constexpr double kLength = 4;     // m, of a link
constexpr double kSeconds = 3;    // of a link
constexpr std::size_t kLinks = 47;

using Errors = ErrorsOf<Space>;

Eigen::Isometry3d noise(RandomStream& random, double metres, double radians) {
  Vector6d twist;
  for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? metres : radians) * random.normal();
  return expSe3(twist);
}

/// Two and a bit laps of 20 links with ups and downs; odometry has the steady errors -`b` and turns
/// with `factor` times the assumed noise; loops to the first lap at four places.
PoseGraph<Space> drive(std::uint64_t seed, const Errors& b, double factor) {
  RandomStream random(seed);
  std::vector<Eigen::Isometry3d> truth = {Eigen::Isometry3d::Identity()};
  PoseGraph<Space> lap;
  lap.nodes = truth;
  for (std::size_t k = 0; k < kLinks; ++k) {
    Vector6d twist;
    twist << 0, 0.3 * std::sin(0.1 * static_cast<double>(k)), kLength, 0.02, 0.3141592, 0.01;
    const Eigen::Isometry3d step = expSe3(twist);
    truth.push_back(truth.back() * step);
    const EffectOf<Space> effect = steadyEffect(step, kSeconds);
    SpatialLink link;
    link.from = k;
    link.to = k + 1;
    link.pose = step * noise(random, 0.01, factor * kNoise) * expSe3(-effect * b);
    link.covariance = isotropic(0.02, kNoise);
    link.robust = false;
    lap.nodes.push_back(lap.nodes.back() * link.pose);
    lap.errors.reported.push_back(link.pose);
    lap.errors.effects.push_back(effect);
    lap.links.push_back(link);
  }
  for (const auto& [from, to] : {std::pair{2, 22}, {9, 29}, {3, 43}, {27, 47}}) {
    SpatialLink loop;
    loop.from = static_cast<std::size_t>(from);
    loop.to = static_cast<std::size_t>(to);
    loop.pose = truth[loop.from].inverse() * truth[loop.to] * noise(random, 0.02, 0.002);
    loop.covariance = isotropic(0.02, 0.002);
    lap.links.push_back(loop);
  }
  for (const SpatialLink& link : lap.links) lap.assumed.push_back(link.covariance);
  assume<Space>({}, lap);
  return lap;
}

/// Residuals of the loops along the reported motions, corrected by b.
Eigen::VectorXd loopResiduals(const PoseGraph<Space>& lap, const Errors& b) {
  std::vector<SpatialLink> links = lap.links;
  SteadyErrors<Space> errors = lap.errors;
  errors.b = b;
  errors.correct(links);
  std::vector<Eigen::Isometry3d> nodes = {lap.nodes[0]};
  for (std::size_t k = 0; k < kLinks; ++k) nodes.push_back(nodes[k] * links[k].pose);
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * (links.size() - kLinks)));
  for (std::size_t k = kLinks; k < links.size(); ++k) {
    all.segment<6>(static_cast<Eigen::Index>(6 * (k - kLinks))) =
        residualOf(links[k], nodes[links[k].from], nodes[links[k].to]);
  }
  return all;
}

struct Dense {
  double log_likelihood = 0;
  Errors b;
};

/// log N(residuals; 0, S), S from links, loops and steady errors by finite differences.
Dense dense(const PoseGraph<Space>& lap, double factor) {
  constexpr double kSmall = 1e-6;
  const Eigen::VectorXd r = loopResiduals(lap, Errors::Zero());
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(r.size(), r.size());
  for (Eigen::Index l = 0; l < r.size() / 6; ++l) {
    S.block<6, 6>(6 * l, 6 * l) = lap.assumed[kLinks + static_cast<std::size_t>(l)];
  }
  for (std::size_t k = 0; k < kLinks; ++k) {
    Eigen::MatrixXd by(r.size(), 6);
    for (int i = 0; i < 6; ++i) {
      PoseGraph<Space> moved = lap;
      moved.errors.reported[k] = lap.errors.reported[k] * expSe3(kSmall * Vector6d::Unit(i));
      const Eigen::VectorXd ahead = loopResiduals(moved, Errors::Zero());
      moved.errors.reported[k] = lap.errors.reported[k] * expSe3(-kSmall * Vector6d::Unit(i));
      by.col(i) = (ahead - loopResiduals(moved, Errors::Zero())) / (2 * kSmall);
    }
    S += by * scaled<Space>(lap.assumed[k], 1, factor) * by.transpose();
  }
  Eigen::MatrixXd by_errors(r.size(), kErrors<Space>);
  for (int i = 0; i < kErrors<Space>; ++i) {
    const Errors small = kSmall * Errors::Unit(i);
    by_errors.col(i) = (loopResiduals(lap, small) - loopResiduals(lap, -small)) / (2 * kSmall);
  }
  const Eigen::MatrixXd prior = lap.errors.precision.cwiseInverse().asDiagonal();
  S += by_errors * prior * by_errors.transpose();
  const Eigen::LDLT<Eigen::MatrixXd> factors(S);
  const Eigen::VectorXd solved = factors.solve(r);
  return {-0.5 * (r.dot(solved) + factors.vectorD().array().log().sum()),
          -prior * by_errors.transpose() * solved};
}

struct Found {
  double log_likelihood = 0;
  Errors b;
};

Found found(PoseGraph<Space> lap, double factor) {
  assume<Space>({.odometry_turns = factor}, lap);
  BorderedSystem<Space> system;
  system.build(lap.nodes.size(), lap.links);
  system.linearise(lap.nodes, lap.links, {}, lap.errors);
  std::vector<Vector6d> step;
  Found result;
  REQUIRE(system.solve(0, step, result.b));
  result.log_likelihood = system.logLikelihood();
  return result;
}

Errors someErrors() { return (Errors() << 0.01, 0.002, -0.001, 0.001, 0.002).finished(); }

}  // namespace

TEST_CASE("steady errors and the probability of the loops are those of the dense computation") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const PoseGraph<Space> lap = drive(seed, 0.2 * someErrors(), 0.2);
    const Dense reference = dense(lap, 1);
    const Found usual = found(lap, 1);
    CAPTURE(seed, usual.b.transpose(), reference.b.transpose());
    CHECK((usual.b - reference.b).norm() < 2e-3 * reference.b.norm() + 1e-5);
    for (const double factor : {0.25, 4.0}) {
      const double expected = dense(lap, factor).log_likelihood - reference.log_likelihood;
      CHECK(found(lap, factor).log_likelihood - usual.log_likelihood ==
            Approx(expected).epsilon(1e-3).margin(1e-3));
    }
  }
}

TEST_CASE("noise is learned by its likelihood, and is as assumed without loops") {
  BorderedSystem<Space> system;
  for (std::uint64_t seed = 11; seed <= 14; ++seed) {
    PoseGraph<Space> quiet = drive(seed, Errors::Zero(), 0.1);
    CHECK(learnAssumptions<Space>({}, quiet, system).odometry_turns < 0.5);
    PoseGraph<Space> wild = drive(seed, Errors::Zero(), 6);
    CHECK(learnAssumptions<Space>({}, wild, system).odometry_turns > 1);
  }
  PoseGraph<Space> open = drive(3, Errors::Zero(), 1);
  open.links.resize(kLinks);
  CHECK(learnAssumptions<Space>({}, open, system).odometry_turns == 1);
}

TEST_CASE("the errors do not depend on the world frame, and stay zero without loops") {
  PoseGraph<Space> lap = drive(3, someErrors(), 1);
  const Found here = found(lap, 1);
  for (Eigen::Isometry3d& node : lap.nodes) {
    node = expSe3((Vector6d() << 300, -20, 70, 0.7, -1.1, 0.4).finished()) * node;
  }
  CHECK((found(lap, 1).b - here.b).norm() < 1e-7);
  lap.links.resize(kLinks);
  CHECK(found(lap, 1).b.norm() < 1e-9);
}

TEST_CASE("a correction turns by its parts and drifts to the left and down") {
  const Eigen::Isometry3d bend = expSe3((Vector6d() << 0, 0, 2, 0, -0.5, 0).finished());
  const double length = bend.translation().norm();
  const Errors b = someErrors();
  const Vector6d by = steadyEffect(bend, 3) * b;
  CHECK(by[4] == Approx(-0.5 * b[0] - 3 * b[1] - length * b[2]));
  CHECK(by[0] == Approx(-length * b[3]));
  CHECK(by[1] == Approx(length * b[4]));
}

}  // namespace tolman::experience_map
