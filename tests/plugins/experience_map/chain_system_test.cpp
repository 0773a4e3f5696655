// SPDX-License-Identifier: BSD-3-Clause
// One Gauss-Newton step against the same normal equations, dense and without any elimination.
#include "chain_system.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

namespace tolman::experience_map {
namespace {

struct Problem {
  std::vector<PlanarPose> nodes;
  std::vector<PlanarLink> links;
};

Eigen::Matrix3d randomCovariance(RandomStream& random) {
  Eigen::Matrix3d root;
  for (double& value : root.reshaped()) value = 0.1 * random.normal();
  return root * root.transpose() + 0.01 * Eigen::Matrix3d::Identity();
}

PlanarPose randomPose(RandomStream& random, double size) {
  return {size * random.normal(), size * random.normal(), random.normal()};
}

PlanarLink randomLink(RandomStream& random, std::size_t from, std::size_t to) {
  return {.from = from,
          .to = to,
          .pose = randomPose(random, 2),
          .covariance = randomCovariance(random),
          .weight = random.uniform(0.2, 1)};
}

/// A chain with the given loops, nothing of which fits.
Problem randomProblem(std::uint64_t seed, std::size_t count,
                      const std::vector<std::pair<std::size_t, std::size_t>>& loops) {
  RandomStream random(seed);
  Problem problem;
  for (std::size_t k = 0; k < count; ++k) {
    problem.nodes.push_back(randomPose(random, 10));
    if (k > 0) problem.links.push_back(randomLink(random, k - 1, k));
  }
  for (const auto& [from, to] : loops) problem.links.push_back(randomLink(random, from, to));
  return problem;
}

std::vector<Eigen::Vector3d> denseStep(const Problem& problem, double damping) {
  const auto size = static_cast<Eigen::Index>(3 * problem.nodes.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
  for (const PlanarLink& link : problem.links) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, size);
    const LinkDerivatives by = derivativesOf(problem.nodes[link.from], problem.nodes[link.to]);
    J.block<3, 3>(0, static_cast<Eigen::Index>(3 * link.from)) = by.by_from;
    J.block<3, 3>(0, static_cast<Eigen::Index>(3 * link.to)) = by.by_to;
    const Eigen::Matrix3d W = link.weight * link.covariance.inverse();
    H += J.transpose() * W * J;
    g += J.transpose() * W * residualOf(link, problem.nodes[link.from], problem.nodes[link.to]);
  }
  H.diagonal() *= 1 + damping;
  const Eigen::Index rest = size - 3;  // node 0 is held
  const Eigen::VectorXd x =
      H.bottomRightCorner(rest, rest).ldlt().solve(Eigen::VectorXd(-g.tail(rest)));
  std::vector<Eigen::Vector3d> step = {Eigen::Vector3d::Zero()};
  for (Eigen::Index k = 0; k < rest; k += 3) step.emplace_back(x.segment<3>(k));
  return step;
}

void checkAgainstDense(const Problem& problem, double damping) {
  ChainSystem system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<Eigen::Vector3d> step;
  REQUIRE(system.solve(damping, step));
  const std::vector<Eigen::Vector3d> expected = denseStep(problem, damping);
  REQUIRE(step.size() == expected.size());
  for (std::size_t k = 0; k < step.size(); ++k) {
    INFO("node " << k);
    CHECK((step[k] - expected[k]).norm() < 1e-6 * (1 + expected[k].norm()));
  }
}

}  // namespace

TEST_CASE("the step is that of the dense system") {
  using Loops = std::vector<std::pair<std::size_t, std::size_t>>;
  SECTION("one long loop and a free tail") {
    checkAgainstDense(randomProblem(1, 40, {{3, 30}}), 0);
  }
  SECTION("no loop at all") { checkAgainstDense(randomProblem(2, 12, {}), 0); }
  SECTION("loops to the held start") {
    checkAgainstDense(randomProblem(3, 20, {{0, 7}, {0, 19}}), 0);
  }
  SECTION("nested, crossing, and into both directions") {
    checkAgainstDense(randomProblem(4, 60, Loops{{2, 50}, {45, 10}, {20, 30}, {59, 25}}), 0);
  }
  SECTION("two loops between the same nodes, and neighbours that are knots") {
    checkAgainstDense(randomProblem(5, 20, Loops{{4, 15}, {15, 4}, {5, 14}, {3, 16}}), 0);
  }
  SECTION("a loop between neighbours") {
    checkAgainstDense(randomProblem(6, 10, Loops{{4, 5}, {7, 6}, {1, 8}}), 0);
  }
  SECTION("damped") { checkAgainstDense(randomProblem(7, 30, Loops{{2, 20}, {9, 29}}), 0.3); }
}

TEST_CASE("one system serves many linearisations") {
  Problem problem = randomProblem(8, 25, {{1, 20}});
  ChainSystem system(problem.nodes.size(), problem.links);
  std::vector<Eigen::Vector3d> step;
  for (int round = 0; round < 3; ++round) {
    problem.nodes[12].x += 1;
    problem.links.back().weight *= 0.5;
    system.linearise(problem.nodes, problem.links);
    REQUIRE(system.solve(0, step));
    CHECK((step[20] - denseStep(problem, 0)[20]).norm() < 1e-6 * (1 + step[20].norm()));
  }
}

TEST_CASE("a node that no link holds makes the system singular, and it says so") {
  Problem problem = randomProblem(9, 10, {{2, 8}});
  std::erase_if(problem.links, [](const PlanarLink& link) { return link.to == 5; });
  ChainSystem system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<Eigen::Vector3d> step;
  std::erase_if(problem.links, [](const PlanarLink& link) { return link.to == 9; });
  ChainSystem loose(problem.nodes.size(), problem.links);
  loose.linearise(problem.nodes, problem.links);
  CHECK_FALSE(loose.solve(0, step));
}

}  // namespace tolman::experience_map
