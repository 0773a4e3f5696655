// SPDX-License-Identifier: BSD-3-Clause
// One Gauss-Newton step against the same normal equations, dense and without any elimination.
#include "chain_system.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

#include "planar_link.hpp"
#include "spatial_link.hpp"

namespace tolman::experience_map {
namespace {

template <class G>
struct Problem {
  std::vector<typename G::Pose> nodes;
  std::vector<PoseLink<G>> links;
};

template <class G>
MatrixOf<G> randomCovariance(RandomStream& random) {
  MatrixOf<G> root;
  for (double& value : root.reshaped()) value = 0.1 * random.normal();
  return root * root.transpose() + 0.01 * MatrixOf<G>::Identity();
}

template <class G>
typename G::Pose randomPose(RandomStream& random, double size) {
  StepOf<G> step;
  for (double& value : step.reshaped()) value = random.normal();
  step.template head<G::kSize == 3 ? 2 : 3>() *= size;
  return moved(G::identity(), step);
}

template <class G>
PoseLink<G> randomLink(RandomStream& random, std::size_t from, std::size_t to) {
  return {.from = from,
          .to = to,
          .pose = randomPose<G>(random, 2),
          .covariance = randomCovariance<G>(random),
          .weight = random.uniform(0.2, 1)};
}

/// A chain with the given loops, nothing of which fits.
template <class G>
Problem<G> randomProblem(std::uint64_t seed, std::size_t count,
                         const std::vector<std::pair<std::size_t, std::size_t>>& loops) {
  RandomStream random(seed);
  Problem<G> problem;
  for (std::size_t k = 0; k < count; ++k) {
    problem.nodes.push_back(randomPose<G>(random, 10));
    if (k > 0) problem.links.push_back(randomLink<G>(random, k - 1, k));
  }
  for (const auto& [from, to] : loops) problem.links.push_back(randomLink<G>(random, from, to));
  return problem;
}

template <class G>
std::vector<StepOf<G>> denseStep(const Problem<G>& problem, double damping) {
  constexpr int kSize = G::kSize;
  const auto size = static_cast<Eigen::Index>(kSize * problem.nodes.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
  for (const PoseLink<G>& link : problem.links) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(kSize, size);
    const auto& from = problem.nodes[link.from];
    const auto& to = problem.nodes[link.to];
    const LinkDerivatives<G> by = derivativesOf(link, from, to);
    J.block<kSize, kSize>(0, static_cast<Eigen::Index>(kSize * link.from)) = by.by_from;
    J.block<kSize, kSize>(0, static_cast<Eigen::Index>(kSize * link.to)) = by.by_to;
    const MatrixOf<G> W = link.weight * link.covariance.inverse();
    H += J.transpose() * W * J;
    g += J.transpose() * W * residualOf(link, from, to);
  }
  H.diagonal() *= 1 + damping;
  const Eigen::Index rest = size - kSize;  // node 0 is held
  const Eigen::VectorXd x =
      H.bottomRightCorner(rest, rest).ldlt().solve(Eigen::VectorXd(-g.tail(rest)));
  std::vector<StepOf<G>> step = {StepOf<G>::Zero()};
  for (Eigen::Index k = 0; k < rest; k += kSize) step.emplace_back(x.segment<kSize>(k));
  return step;
}

template <class G>
void checkAgainstDense(const Problem<G>& problem, double damping) {
  ChainSystem<G> system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<StepOf<G>> step;
  REQUIRE(system.solve(damping, step));
  const std::vector<StepOf<G>> expected = denseStep(problem, damping);
  REQUIRE(step.size() == expected.size());
  for (std::size_t k = 0; k < step.size(); ++k) {
    INFO("node " << k);
    CHECK((step[k] - expected[k]).norm() < 1e-6 * (1 + expected[k].norm()));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("the step is that of the dense system", "", Plane, Space) {
  using Loops = std::vector<std::pair<std::size_t, std::size_t>>;
  SECTION("one long loop and a free tail") {
    checkAgainstDense(randomProblem<TestType>(1, 40, {{3, 30}}), 0);
  }
  SECTION("no loop at all") { checkAgainstDense(randomProblem<TestType>(2, 12, {}), 0); }
  SECTION("loops to the held start") {
    checkAgainstDense(randomProblem<TestType>(3, 20, {{0, 7}, {0, 19}}), 0);
  }
  SECTION("nested, crossing, and into both directions") {
    checkAgainstDense(randomProblem<TestType>(4, 60, Loops{{2, 50}, {45, 10}, {20, 30}, {59, 25}}),
                      0);
  }
  SECTION("two loops between the same nodes, and neighbours that are knots") {
    checkAgainstDense(randomProblem<TestType>(5, 20, Loops{{4, 15}, {15, 4}, {5, 14}, {3, 16}}), 0);
  }
  SECTION("a loop between neighbours") {
    checkAgainstDense(randomProblem<TestType>(6, 10, Loops{{4, 5}, {7, 6}, {1, 8}}), 0);
  }
  SECTION("damped") {
    checkAgainstDense(randomProblem<TestType>(7, 30, Loops{{2, 20}, {9, 29}}), 0.3);
  }
}

TEMPLATE_TEST_CASE("one system serves many linearisations", "", Plane, Space) {
  Problem<TestType> problem = randomProblem<TestType>(8, 25, {{1, 20}});
  ChainSystem<TestType> system(problem.nodes.size(), problem.links);
  std::vector<StepOf<TestType>> step;
  for (int round = 0; round < 3; ++round) {
    problem.nodes[12] = moved(problem.nodes[12], StepOf<TestType>::Unit(0));
    problem.links.back().weight *= 0.5;
    system.linearise(problem.nodes, problem.links);
    REQUIRE(system.solve(0, step));
    CHECK((step[20] - denseStep(problem, 0)[20]).norm() < 1e-6 * (1 + step[20].norm()));
  }
}

TEMPLATE_TEST_CASE("a node that no link holds makes the system singular, and it says so", "", Plane,
                   Space) {
  Problem<TestType> problem = randomProblem<TestType>(9, 10, {{2, 8}});
  std::erase_if(problem.links, [](const PoseLink<TestType>& link) { return link.to == 5; });
  ChainSystem<TestType> system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<StepOf<TestType>> step;
  std::erase_if(problem.links, [](const PoseLink<TestType>& link) { return link.to == 9; });
  ChainSystem<TestType> loose(problem.nodes.size(), problem.links);
  loose.linearise(problem.nodes, problem.links);
  CHECK_FALSE(loose.solve(0, step));
}

}  // namespace tolman::experience_map
