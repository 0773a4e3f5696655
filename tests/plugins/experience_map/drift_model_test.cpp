// SPDX-License-Identifier: BSD-3-Clause
// The learned drift against the probability of the loops' residuals, computed densely and with
// finite differences.
#include "drift_model.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <tolman/context.hpp>

#include "uncertain_pose.hpp"

namespace tolman::experience_map {
namespace {

constexpr double kRotation = 0.002;  // rad/m, prior
constexpr double kSteady = 0.01;     // prior
constexpr double kLength = 4;        // m, of a link
constexpr std::size_t kNodes = 48;

struct Lap {
  std::vector<Eigen::Isometry3d> nodes;  ///< by dead reckoning
  std::vector<SpatialLink> links;
  std::vector<double> lengths;
};

Eigen::Isometry3d noise(RandomStream& random, double metres, double radians) {
  Vector6d twist;
  for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? metres : radians) * random.normal();
  return expSe3(twist);
}

/// Two and a bit laps of 20 links with ups and downs; odometry drifts by `steady` and bends by
/// `bend` rad/m; loops to the first lap at four places.
Lap drive(std::uint64_t seed, const Eigen::Vector3d& steady, double bend) {
  RandomStream random(seed);
  Vector6d drift = Vector6d::Zero();
  drift.head<3>() = kLength * steady;
  std::vector<Eigen::Isometry3d> truth = {Eigen::Isometry3d::Identity()};
  Lap lap;
  lap.nodes = truth;
  for (std::size_t k = 1; k < kNodes; ++k) {
    Vector6d step;
    step << 0, 0.3 * std::sin(0.1 * static_cast<double>(k)), kLength, 0.02, 0.3141592, 0.01;
    truth.push_back(truth.back() * expSe3(step));
    SpatialLink link;
    link.from = k - 1;
    link.to = k;
    link.pose =
        truth[k - 1].inverse() * truth[k] * noise(random, 0.01, bend * kLength) * expSe3(drift);
    link.covariance = isotropic(0.02, kRotation * kLength);
    link.robust = false;
    lap.nodes.push_back(lap.nodes.back() * link.pose);
    lap.links.push_back(link);
    lap.lengths.push_back(kLength);
  }
  for (const auto& [from, to] : {std::pair{2, 22}, {9, 29}, {3, 43}, {27, 47}}) {
    SpatialLink loop;
    loop.from = static_cast<std::size_t>(from);
    loop.to = static_cast<std::size_t>(to);
    loop.pose = truth[loop.from].inverse() * truth[loop.to] * noise(random, 0.02, 0.002);
    loop.covariance = isotropic(0.02, 0.002);
    lap.links.push_back(loop);
  }
  return lap;
}

Eigen::VectorXd loopResiduals(const Lap& lap, const std::vector<SpatialLink>& links) {
  std::vector<Eigen::Isometry3d> nodes = {lap.nodes[0]};
  for (std::size_t k = 0; k < lap.lengths.size(); ++k) nodes.push_back(nodes[k] * links[k].pose);
  const std::size_t loops = lap.links.size() - lap.lengths.size();
  Eigen::VectorXd all(static_cast<Eigen::Index>(6 * loops));
  for (std::size_t l = 0; l < loops; ++l) {
    const SpatialLink& loop = lap.links[lap.lengths.size() + l];
    all.segment<6>(static_cast<Eigen::Index>(6 * l)) =
        residualOf(loop, nodes[loop.from], nodes[loop.to]);
  }
  return all;
}

struct Oracle {
  double log_likelihood = 0;
  Eigen::Vector3d steady;
};

/// log N(residuals; 0, S), S from links, loops and steady drift by finite differences.
Oracle oracle(const Lap& lap, double rotation) {
  constexpr double kSmall = 1e-6;
  const Eigen::VectorXd r = loopResiduals(lap, lap.links);
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(r.size(), r.size());
  for (Eigen::Index l = 0; l < r.size() / 6; ++l) {
    S.block<6, 6>(6 * l, 6 * l) =
        lap.links[lap.lengths.size() + static_cast<std::size_t>(l)].covariance;
  }
  Eigen::MatrixXd by_steady = Eigen::MatrixXd::Zero(r.size(), 3);
  for (std::size_t k = 0; k < lap.lengths.size(); ++k) {
    Eigen::MatrixXd by(r.size(), 6);
    for (int i = 0; i < 6; ++i) {
      std::vector<SpatialLink> links = lap.links;
      links[k].pose = links[k].pose * expSe3(kSmall * Vector6d::Unit(i));
      const Eigen::VectorXd ahead = loopResiduals(lap, links);
      links[k].pose = lap.links[k].pose * expSe3(-kSmall * Vector6d::Unit(i));
      by.col(i) = (ahead - loopResiduals(lap, links)) / (2 * kSmall);
    }
    S += by * isotropic(0.02, rotation * kLength) * by.transpose();
    by_steady -= kLength * by.leftCols<3>();
  }
  S += kSteady * kSteady * by_steady * by_steady.transpose();
  const Eigen::LDLT<Eigen::MatrixXd> factors(S);
  const Eigen::VectorXd solved = factors.solve(r);
  return {-0.5 * (r.dot(solved) + factors.vectorD().array().log().sum()),
          -kSteady * kSteady * by_steady.transpose() * solved};
}

/// Among the prior's rotation, a quarter and a sixteenth, under a prior that is a factor of ten
/// wide.
DriftModel expected(const Lap& lap) {
  DriftModel best;
  double most = -1e300;
  for (int quarter = 0; quarter <= 2; ++quarter) {
    const double rotation = kRotation / std::pow(4, quarter);
    const Oracle found = oracle(lap, rotation);
    const double away = quarter * std::log(4.0) / 2.3;
    const double likelihood = found.log_likelihood - 0.5 * away * away;
    if (likelihood <= most) continue;
    most = likelihood;
    best = {rotation, found.steady};
  }
  return best;
}

DriftModel learned(const Lap& lap) {
  ChainSystem<Space> system;
  return learnDrift(lap.nodes, lap.links, lap.lengths, {kRotation, kSteady}, system);
}

}  // namespace

TEST_CASE("the drift is the one under which the loops' residuals are most likely") {
  const Eigen::Vector3d sinks(0.001, 0.004, -0.002);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    for (const double bend : {0.0, 0.0004, 0.002}) {
      const Lap lap = drive(seed, sinks, bend);
      const DriftModel drift = learned(lap);
      const DriftModel dense = expected(lap);
      CAPTURE(seed, bend, drift.steady.transpose(), dense.steady.transpose());
      CHECK(drift.rotation == Approx(dense.rotation));
      CHECK((drift.steady - dense.steady).norm() < 2e-3 * dense.steady.norm() + 1e-5);
    }
  }
}

TEST_CASE(
    "a small rotation drift is distinguished from a large one, and the steady drift is found") {
  const Eigen::Vector3d sinks(0, 0.004, 0);
  for (std::uint64_t seed = 11; seed <= 16; ++seed) {
    const DriftModel straight = learned(drive(seed, sinks, 0));
    CAPTURE(seed, straight.steady.transpose());
    CHECK(straight.rotation < 0.3 * kRotation);
    CHECK((straight.steady - sinks).norm() < 0.002);
    CHECK(learned(drive(seed, sinks, kRotation)).rotation >= 0.5 * kRotation);
  }
}

TEST_CASE("the drift does not depend on the world frame") {
  Lap lap = drive(3, {0, -0.003, 0.001}, 0.0004);
  const DriftModel here = learned(lap);
  Vector6d twist;
  twist << 300, -20, 70, 0.7, -1.1, 0.4;
  for (Eigen::Isometry3d& node : lap.nodes) node = expSe3(twist) * node;
  const DriftModel there = learned(lap);
  CHECK(there.rotation == here.rotation);
  CHECK((there.steady - here.steady).norm() < 1e-8);
}

TEST_CASE("without loops, or with rejected ones only, the prior stays") {
  Lap lap = drive(4, {0, 0.004, 0}, 0);
  for (SpatialLink& link : lap.links) link.weight = link.robust ? 1e-6 : 1;
  const DriftModel rejected = learned(lap);
  CHECK(rejected.rotation == kRotation);
  CHECK(rejected.steady.norm() < 1e-3);
  lap.links.resize(lap.lengths.size());
  const DriftModel none = learned(lap);
  CHECK(none.rotation == kRotation);
  CHECK(none.steady.norm() < 1e-9);
}

TEST_CASE("a prior of no steady drift leaves none") {
  const Lap lap = drive(5, {0, 0.004, 0}, 0);
  ChainSystem<Space> system;
  const DriftModel found = learnDrift(lap.nodes, lap.links, lap.lengths, {kRotation, 0}, system);
  CHECK(found.steady.norm() == 0);
}

TEST_CASE("a link under another drift: the end moves back, the covariance shrinks, a gap stays") {
  SpatialLink link;
  link.pose = expSe3((Vector6d() << 1, 2, 3, 0.1, 0.2, 0.3).finished());
  link.covariance = isotropic(0.1, 0.01);
  const DriftModel drift = {0.001, {0, 0.01, 0}};
  const SpatialLink moved = withDrift(link, 4, 0.002, drift);
  const Eigen::Vector3d back = (link.pose.inverse() * moved.pose).translation();
  CHECK((back - Eigen::Vector3d(0, -0.04, 0)).norm() < 1e-12);
  CHECK(moved.covariance(4, 4) == Approx(1e-4 - 16 * (4e-6 - 1e-6)));
  CHECK(moved.covariance(1, 1) == Approx(0.01));
  CHECK(withDrift(link, 0, 0.002, drift).pose.isApprox(link.pose, 0));
}

}  // namespace tolman::experience_map
